# Recipe of Spack: ci/release --homepage URL fills in version, checksum and address, and writes the recipe for a package repository.
from spack.package import *


class Plumbline(CMakePackage):
    """Verification and validation harness for the Material Point Method: published cases against exact solutions."""

    homepage = "@HOMEPAGE@"
    url = "@HOMEPAGE@/releases/download/v@VERSION@/plumbline-@VERSION@.tar.gz"

    license("MIT", checked_by="plumbline")

    version("@VERSION@", sha256="@SHA256@")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("eigen@3.4:", type=("build", "link", "run"))
    depends_on("gsl")
    depends_on("hdf5~mpi")
    depends_on("nlohmann-json@3.10:", type="build")
    depends_on("cli11", type="build")
    depends_on("fmt")
    depends_on("boost@1.74: +math", type="build")
    depends_on("python@3.11:", type=("build", "run"))
    depends_on("py-numpy", type=("build", "run"))
    depends_on("py-scipy", type=("build", "run"))
    depends_on("py-h5py", type=("build", "run"))
    depends_on("py-matplotlib", type=("build", "run"))
    depends_on("py-pillow", type=("build", "run"))
    depends_on("py-jinja2", type=("build", "run"))
    depends_on("py-jsonschema", type="build")
    depends_on("py-mpmath", type="build")
    depends_on("py-pytest", type="build")

    generator("ninja")

    def cmake_args(self):
        # Spack's compiler wrapper chooses the instruction set of the target.
        return [
            self.define("PLUMBLINE_ARCH", ""),
            self.define("PLUMBLINE_WERROR", False),
            self.define("PLUMBLINE_BUILD_TESTS", False),
            self.define("PLUMBLINE_PYTHON", python.path),
        ]

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def verify_a_case(self):
        Executable(join_path(self.prefix.bin, "plumbline"))("verify", "sod", "--results", join_path(self.stage.path, "results"))
