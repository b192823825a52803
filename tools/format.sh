#!/bin/sh
# Formats everything as `./contact test style` wants it: C++, Python, TypeScript and JavaScript; or only the paths given.
set -eu
cd "$(dirname -- "$0")/.."
venv=build/venv/bin
listed() { # the project's files of some kinds, among the paths asked for
  kinds=$1
  shift
  git ls-files --cached --others --exclude-standard -- "$@" | grep -E "\.($kinds)\$" | grep -v third_party/ |
    while IFS= read -r file; do [ ! -f "$file" ] || printf '%s\n' "$file"; done
}
[ $# -gt 0 ] || set -- .
listed 'cpp|hpp' "$@" | xargs -r "$venv/clang-format" -i
listed 'py' "$@" | xargs -r "$venv/ruff" format -q
listed 'py' "$@" | xargs -r "$venv/ruff" check -q --fix-only
listed 'ts|mts|mjs|js|css' "$@" | xargs -r page/node_modules/.bin/biome check --write --no-errors-on-unmatched
listed 'json' "$@" | grep '^page/' | xargs -r page/node_modules/.bin/biome check --write --no-errors-on-unmatched
