#include "platform/terminal.hpp"

#include <string>
#include <vector>

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// After windows.h, which it needs.
#include <shellapi.h>

#include "platform/files.hpp"
#include "platform/windows/wide.hpp"

namespace circumspect::platform {
namespace {

// What a descriptor shows on; a null device, which _isatty takes for a terminal, is none.
HANDLE console_of(int descriptor) {
  const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
  DWORD mode = 0;
  return GetConsoleMode(handle, &mode) != 0 ? handle : nullptr;
}

}  // namespace

// Lines can be taken back where sequences of characters are obeyed, as from Windows 10 on.
bool is_terminal(int descriptor) {
  const HANDLE console = console_of(descriptor);
  DWORD mode = 0;
  return console != nullptr && GetConsoleMode(console, &mode) != 0 &&
         SetConsoleMode(console, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

bool shows_colours(int descriptor) { return is_terminal(descriptor); }

std::size_t terminal_width(int descriptor) {
  const HANDLE console = console_of(descriptor);
  CONSOLE_SCREEN_BUFFER_INFO about = {};
  if (console == nullptr || GetConsoleScreenBufferInfo(console, &about) == 0) return 0;
  return static_cast<std::size_t>(about.srWindow.Right - about.srWindow.Left + 1);
}

// argv has them in the code page of the system, with "?" for what that lacks.
char** arguments(int& argc, char** argv) {
  int count = 0;
  wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
  if (words == nullptr) return argv;
  static std::vector<std::string> texts;
  static std::vector<char*> pointers;
  for (int i = 0; i < count; ++i) texts.push_back(to_utf8(words[i]));
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  LocalFree(words);
  argc = count;
  return pointers.data();
}

void prepare_standard_files() {
  for (const int file : {kStandardInput, kStandardOutput, kStandardError}) {
    if (_get_osfhandle(file) < 0) {
      // Opened the wrong way round, so that reading from it or writing to it still fails.
      const int opened = _open("NUL", file == kStandardInput ? _O_WRONLY : _O_RDONLY);
      if (opened >= 0 && opened != file) {
        _dup2(opened, file);
        _close(opened);
      }
    }
    _setmode(file, _O_BINARY);
  }
  SetConsoleOutputCP(CP_UTF8);
}

}  // namespace circumspect::platform
