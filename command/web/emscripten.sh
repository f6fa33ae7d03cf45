# To be sourced: what Debian's Emscripten needs of its surroundings.
# Its scripts ask Node for more than one that is not Debian's finds by itself, and would take its
# fetch() for a page's.
export NODE_PATH="${NODE_PATH:+$NODE_PATH:}/usr/share/nodejs"
case "$(node --version)" in
  v1[89].* | v2*) export NODE_OPTIONS="${NODE_OPTIONS:-} --no-experimental-fetch" ;;
esac
