#!/bin/sh
# As root, on a bare Debian: installs what exercises need, and makes a user who may install more. The Python packages that
# it makes beside itself are not used: each clone has its own.
set -eu
export DEBIAN_FRONTEND=noninteractive
apt-get -q update
apt-get -q -y install --no-install-recommends ca-certificates git sudo
"$(dirname -- "$0")/../contact" setup --for program
id reader > /dev/null 2>&1 || useradd --create-home --shell /bin/bash reader
printf 'reader ALL=(ALL) NOPASSWD:ALL\n' > /etc/sudoers.d/reader
