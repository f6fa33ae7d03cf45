#include "oracle/formats/bytes/unfinished_file.hpp"

#include <cerrno>
#include <cstddef>

#include "platform/files.hpp"

namespace circumspect::formats {

FileBuffer::int_type FileBuffer::overflow(int_type c) {
  if (!write_out()) return traits_type::eof();
  if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
  return traits_type::not_eof(c);
}

int FileBuffer::sync() { return write_out() ? 0 : -1; }

bool FileBuffer::write_out() {
  for (const char* at = pbase(); failure == 0 && at < pptr();) {
    const std::ptrdiff_t count =
        platform::write_some(file_, at, static_cast<std::size_t>(pptr() - at));
    if (count >= 0) at += count;
    if (count < 0) failure = errno;
  }
  setp(block_.data(), block_.data() + block_.size());
  return failure == 0;
}

UnfinishedFile::UnfinishedFile(const std::string& path)
    : file_(path), buffer_(file_.descriptor()), stream_(&buffer_) {
  if (file_.descriptor() >= 0) return;
  buffer_.failure = errno;
  stream_.setstate(std::ios::badbit);
}

int UnfinishedFile::finish(bool to_disk) {
  stream_.flush();
  if (buffer_.failure == 0 && !stream_)
    buffer_.failure = EIO;  // the writer reports that the file is incomplete
  if (buffer_.failure == 0 && to_disk && !platform::put_on_disk(file_.descriptor()))
    buffer_.failure = errno;
  if (buffer_.failure == 0 && !file_.give_name()) buffer_.failure = errno;
  return buffer_.failure;
}

int write_whole_file(const std::string& path, const std::string& text) {
  UnfinishedFile file(path);
  file.stream() << text;
  return file.finish(true);
}

}  // namespace circumspect::formats
