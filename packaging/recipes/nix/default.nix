# nix-build: the command and the libraries.
{ pkgs ? import <nixpkgs> { } }:

pkgs.stdenv.mkDerivation rec {
  pname = "circumspect";
  version = "@VERSION@";

  src = pkgs.fetchurl {
    url = "https://github.com/circumspect/circumspect/releases/download/v${version}/circumspect-${version}-source.tar.gz";
    sha256 = "@SHA256@";
  };

  nativeBuildInputs = [ pkgs.cmake pkgs.ninja ];
  buildInputs = with pkgs; [ gmp mpfr cadical pugixml zlib zstd xz tbb fmt cgal boost cli11 nlohmann_json tl-expected ];

  cmakeFlags = [ "-DCIRCUMSPECT_QUICK_BUILD=ON" "-DCIRCUMSPECT_BUILD_TESTS=OFF" ];
  ninjaFlags = [ "circumspect_cli" "circumspect_archive" ];
  installPhase = ''
    cmake --install . --component command
    cmake --install . --component harness
  '';

  meta = {
    description = "The exact oracle for triangulations: judges any mesh, exactly, with a witness";
    homepage = "https://github.com/circumspect/circumspect";
    license = pkgs.lib.licenses.mit;
    mainProgram = "circumspect";
    platforms = pkgs.lib.platforms.linux;
  };
}
