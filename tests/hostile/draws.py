"""All kinds of random calls. Each is a generator that yields calls and is sent their outcomes; `None` is answered with the folder that
they are made in. It ends with `Skipped` where it would take too long, and yields a `Fault` of its own where two outcomes disagree."""
import handed_in  # noqa: F401  registers its kinds, as the next two do
import runs  # noqa: F401
import surroundings  # noqa: F401
from kinds import KINDS, Skipped, pick

__all__ = ["KINDS", "Skipped", "pick"]
