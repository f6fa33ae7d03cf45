class Circumspect < Formula
  desc "Exact oracle for triangulations: judges any mesh, with a witness"
  homepage "https://github.com/circumspect/circumspect"
  url "https://github.com/circumspect/circumspect/releases/download/v@VERSION@/circumspect-@VERSION@-source.tar.gz"
  sha256 "@SHA256@"
  license "MIT"

  depends_on "boost" => :build
  depends_on "cgal" => :build
  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "tl-expected" => :build
  depends_on "cadical"
  depends_on "fmt"
  depends_on "gmp"
  depends_on "mpfr"
  depends_on "pugixml"
  depends_on "tbb"
  depends_on "xz"
  depends_on "zstd"

  uses_from_macos "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCIRCUMSPECT_QUICK_BUILD=ON",
           "-DCIRCUMSPECT_BUILD_TESTS=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "circumspect_cli", "circumspect_archive"
    system "cmake", "--install", "build", "--component", "command"
    system "cmake", "--install", "build", "--component", "harness"
  end

  test do
    (testpath/"x.node").write "4 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0.9 0.9\n"
    (testpath/"x.ele").write "2 3 0\n0 0 1 3\n1 0 3 2\n"
    assert_match "holds: delaunay", shell_output("#{bin}/circumspect check x.ele")
  end
end
