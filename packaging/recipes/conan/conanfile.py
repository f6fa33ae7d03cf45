"""Conan 2: the libraries that judge arrays, and the harness for tests."""
from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get


class Circumspect(ConanFile):
    name = "circumspect"
    version = "@VERSION@"
    description = "The exact oracle for triangulations: judges what a program made of points, with a witness"
    license = "MIT"
    homepage = url = "https://github.com/circumspect/circumspect"
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def requirements(self):
        for name in ("boost/1.83.0", "cgal/5.6.1", "fmt/10.2.1", "gmp/6.3.0", "mpfr/4.2.1", "nlohmann_json/3.11.3",
                     "onetbb/2021.12.0", "tl-expected/1.1.0"):
            self.requires(name)

    def layout(self):
        cmake_layout(self)

    def source(self):
        get(self, f"{self.url}/releases/download/v{self.version}/circumspect-{self.version}-source.tar.gz",
            sha256="@SHA256@", strip_root=True)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for name, value in {"QUICK_BUILD": True, "BUILD_TESTS": False, "BUILD_COMMAND": False}.items():
            toolchain.cache_variables[f"CIRCUMSPECT_{name}"] = value
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="circumspect_archive")

    def package(self):
        CMake(self).install(component="harness")
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the package brings its own circumspectConfig.cmake
        self.cpp_info.builddirs = ["lib/cmake/circumspect"]
