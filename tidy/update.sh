#!/bin/bash
# Writes what follows from the rest of the project, once the command is built: the files and tables of the corpus, golden rows, the
# tables and outputs of the pages, their images. Read the difference before you commit it.
#   update.sh COMMAND
set -euo pipefail
command=$(realpath "$1")
cd "$(dirname "$0")/.."
export PYTHONDONTWRITEBYTECODE=1
python3 corpus/make/make.py
python3 corpus/golden.py "$command" --update
python3 tidy/readme.py "$command" --update
python3 tidy/proved.py --update
oracle/picture/page/images.sh "$command" docs/images
