#!/usr/bin/env bash
# Gradescope runs this once, as root, when the autograder's image is built; so does the Dockerfile
# beside it. It installs what grading needs, builds it, and tries it on a submission of stubs.
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
export DEBIAN_FRONTEND=noninteractive

# shellcheck source=/dev/null
. /etc/os-release
case "${ID:-}-${VERSION_ID:-}" in
  debian-12 | debian-13 | ubuntu-24.04) ;;
  *)
    echo "setup.sh: ${PRETTY_NAME:-this system} is not one of those that this autograder is tried on: Debian 12," \
      "Debian 13 and Ubuntu 24.04. Choose Ubuntu 24.04 as the base image if what follows fails." >&2
    ;;
esac

# Only the grader may enter this folder.
chmod go-rwx "$here/options.json"
if [ -d "$here/private" ]; then chmod -R go-rwx "$here/private"; fi

apt-get update
cd "$here/contact"
./contact setup --for program
./contact list > /dev/null

# Builds the tests of the exercises that are graded, so that no student waits for it.
trial=$(mktemp -d)
trap 'rm -rf "$trial"' EXIT
if ! PYTHONPATH=grading build/venv/bin/python -m reports.autograder_run try "$here" "$trial/results.json"; then
  echo "setup.sh: this image cannot grade yet; the lines above say why. If it is the sandbox, it may still work when" \
    "Gradescope runs it: hand in a test submission and read what the autograder printed." >&2
fi
