// Files that zstd packed, and blocks of LZMA: what they hold, and what is refused.
#include <doctest/doctest.h>

#include "inputs/scratch_folder_test.hpp"
#include "oracle/formats/bytes/packed.hpp"
#include "oracle/formats/bytes/zstd.hpp"
#include "oracle/formats/lzma.hpp"
#include "oracle/formats/mesh_files.hpp"
#include "oracle/formats/reading_test.hpp"
#include "oracle/formats/written_elements_test.hpp"

#ifdef CIRCUMSPECT_ZSTD
#include <zstd.h>
#endif
#ifdef CIRCUMSPECT_LZMA
#include <lzma.h>
#endif

namespace circumspect::formats {
namespace {

const std::string kNodesAlone = "3 2\n1 0 0\n2 1 0\n3 0 1\n";

std::string said_of_packed(const std::string& bytes) {
  const ScratchFolder folder;
  const std::string path = folder.write("x.node.zst", bytes);
  const auto source = load_unpacked(path);
  return source ? source->text : error_of(source).substr(path.size());
}

}  // namespace

#ifdef CIRCUMSPECT_ZSTD

namespace {

std::string by_zstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), bytes.data(), bytes.size()));
  ZSTD_freeCCtx(context);
  return packed;
}

}  // namespace

TEST_CASE("zstd: a mesh in two packed files, and several frames that are one file") {
  CHECK(name_inside("a/x.ele.zst") == "a/x.ele");
  CHECK(extension_inside("x.NODE.zst") == ".node");
  const ScratchFolder folder;
  const std::string ele = folder.write("x.1.ele.zst", by_zstd("1 3\n1 1 2 3\n"));
  const std::string node = folder.write("x.1.node.zst", by_zstd(kNodesAlone));
  for (const std::string& mesh : {ele, node}) {
    const auto read = read_mesh({.mesh = mesh});
    REQUIRE_MESSAGE(read, error_of(read));
    CHECK(read->mesh.simplices.lists() == std::vector<Simplex>{{0, 1, 2}});
    CHECK(read->points_name == node);
  }
  CHECK(said_of_packed(by_zstd("3 2\n") + by_zstd("") + by_zstd(kNodesAlone.substr(4))) ==
        kNodesAlone);
}

TEST_CASE("zstd: what is cut off, changed or swells too much is refused") {
  const std::string packed = by_zstd(kNodesAlone);
  CHECK(said_of_packed(packed) == kNodesAlone);
  for (std::size_t size = kZstdMagic.size(); size < packed.size(); ++size) {
    CHECK(said_of_packed(packed.substr(0, size)) ==
          ": expected the end of the packed data, found the end of the file");
  }
  std::string changed = packed;
  changed.back() ^= 1;  // of the checksum
  for (const std::string& bytes : {changed, packed + "more"}) {
    CHECK(said_of_packed(bytes).starts_with(": expected data that zstd packed, found a fault"));
  }
  CHECK(said_of_packed(by_zstd(std::string(1'000'000, ' '))).size() == 1'000'000);
  const std::string bomb = by_zstd(std::string(1'000'001, ' '));
  CHECK(said_of_packed(bomb) == ": expected at most 1000000 bytes in a packed file of " +
                                    std::to_string(bomb.size()) + ", found more (unpack it first)");
}

#else

TEST_CASE("zstd: without the library the message says what to do") {
  CHECK(said_of_packed(std::string(kZstdMagic) + "\x20").find("unpack it first by zstd -d") !=
        std::string::npos);
}

#endif

#ifdef CIRCUMSPECT_LZMA

TEST_CASE("lzma: a block gives exactly the bytes for which there is room, or nothing") {
  std::string packed(1000, '\0');
  std::size_t size = 0;
  const std::string text = kNodesAlone + std::string(300, 'x');
  REQUIRE(lzma_easy_buffer_encode(0, LZMA_CHECK_CRC32, nullptr,
                                  reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
                                  reinterpret_cast<std::uint8_t*>(packed.data()), &size,
                                  packed.size()) == LZMA_OK);
  packed.resize(size);
  const auto unpacked = [](const std::string& block, std::size_t room) {
    std::string made(room, '\0');
    return lzma_unpacker()(block, made) ? made : "a fault";
  };
  CHECK(unpacked(packed, text.size()) == text);
  CHECK(unpacked(packed, text.size() - 1) == "a fault");
  CHECK(unpacked(packed, text.size() + 1) == "a fault");
  CHECK(unpacked(packed + "x", text.size()) == "a fault");
  for (std::size_t end = 0; end < packed.size(); ++end) {
    CHECK(unpacked(packed.substr(0, end), text.size()) == "a fault");
  }
}

TEST_CASE("lzma: arrays of VTK are packed by it") {
  std::string numbers;
  for (const double x : {0.5, 0.25, 0.125}) {
    numbers += stored(std::bit_cast<std::uint64_t>(x), 8, ByteOrder::kLittleEndian);
  }
  std::string packed(1000, '\0'), head;
  std::size_t size = 0;
  REQUIRE(lzma_easy_buffer_encode(0, LZMA_CHECK_CRC32, nullptr,
                                  reinterpret_cast<const std::uint8_t*>(numbers.data()),
                                  numbers.size(), reinterpret_cast<std::uint8_t*>(packed.data()),
                                  &size, packed.size()) == LZMA_OK);
  packed.resize(size);
  for (const std::size_t number : {std::size_t{1}, numbers.size(), std::size_t{0}, size}) {
    head += stored(number, 4, ByteOrder::kLittleEndian);
  }
  const auto file = read_vtu(
      named("<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkLZMADataCompressor\">"
            "<UnstructuredGrid><Piece NumberOfPoints=\"1\" NumberOfCells=\"0\"><Points><DataArray "
            "type=\"Float64\" NumberOfComponents=\"3\" format=\"binary\">" +
            base64(head) + base64(packed) +
            "</DataArray></Points></Piece></UnstructuredGrid></VTKFile>"),
      kDouble);
  REQUIRE_MESSAGE(file, error_of(file));
  CHECK(file->points.points ==
        std::vector<Point>{{Rational(1, 2), Rational(1, 4), Rational(1, 8)}});
}

#else

TEST_CASE("lzma: without the library nothing unpacks it") {
  const bool is_there = lzma_unpacker() != nullptr;
  CHECK_FALSE(is_there);
}

#endif

}  // namespace circumspect::formats
