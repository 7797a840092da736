// Wrong parts: each stands in a file of its own that registers it, as a plug-in would; its title is the defect.
#pragma once

namespace plumbline::wrong {

inline const char* const here = "tests/parts";  // what stands as source of a part that nobody has published

}  // namespace plumbline::wrong
