#!/bin/sh
# Puts the two amalgamated files of Catch2's source, in the version of the installed libcatch2-dev, into
# build/catch2/extras: the tests in WebAssembly are linked with them. Nothing on the system changes: the source
# package is fetched with private package lists below build/.
# Exit code 0: success; 3: they are not available here, with a message that says why.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
target=$root/build/catch2
private=$root/build/catch2.apt

cannot() {
  printf 'fetch_catch2_source: %s\n' "$*" >&2
  exit 3
}

command -v apt-get >/dev/null 2>&1 || cannot "this machine has no apt-get. Download the source of Catch2 3.x" \
  "and copy its extras/catch_amalgamated.hpp and .cpp to $target/extras."
# Debian calls it libcatch2-dev, Ubuntu 24.04 catch2.
package=libcatch2-dev
dpkg-query -W "$package" >/dev/null 2>&1 || package=catch2
# ${...} here is dpkg-query's own language.
# shellcheck disable=SC2016
version=$(dpkg-query -W -f '${source:Version}' "$package" 2>/dev/null || :)
case $version in
  '') cannot "Catch2's package (libcatch2-dev) is not installed; ./contact setup installs it." ;;
  [012].*) cannot "$package is $version, and this needs version 3; ./contact setup installs it." ;;
esac
if [ -f "$target/extras/catch_amalgamated.cpp" ] && [ "$(cat "$target/VERSION" 2>/dev/null)" = "$version" ]; then
  exit 0
fi

# Where the installed version came from: "URI SUITE", one a line. Empty if the machine's package lists are gone.
origins=$(LC_ALL=C apt-cache policy "$package" | awk '
  /^ \*\*\* /   { installed = 1; next }
  /^     [^ ]/  { installed = 0 }
  installed && $2 !~ /^\/var\/lib\/dpkg/ && NF >= 4 { split($3, part, "/"); print $2, part[1] }' | sort -u)

# The machine's own sources of those origins (of all, if none is known), with "deb" turned into "deb-src".
# Options such as the signing key stay as they are.
rm -rf "$private"
mkdir -p "$private/sources" "$private/lists/partial" "$private/cache/archives/partial" "$private/download"
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ -f "$file" ] || continue
  awk -v origins="$origins" '
    $1 != "deb" { next }
    {
      at = 2
      if ($2 ~ /^\[/) { while ($at !~ /\]$/ && at <= NF) at++; at++ }
      uri = $at; sub(/\/$/, "", uri)
      if (origins != "" && index("\n" origins "\n", "\n" uri " " $(at + 1) "\n") == 0) next
      sub(/^[ \t]*deb/, "deb-src"); print
    }' "$file" >>"$private/sources/lines.list"
done
for file in /etc/apt/sources.list.d/*.sources; do
  [ -f "$file" ] || continue
  awk -v origins="$origins" '
    function emit(   i, j, n, m, uris, suites, wanted, uri, line, skip) {
      n = split(value["uris"], uris, " "); m = split(value["suites"], suites, " "); wanted = ""
      for (i = 1; i <= n; i++) for (j = 1; j <= m; j++) {
        uri = uris[i]; sub(/\/$/, "", uri)
        if (origins == "" || index("\n" origins "\n", "\n" uri " " suites[j] "\n")) wanted = wanted " " suites[j]
      }
      if (wanted != "" && value["types"] ~ /deb/ && tolower(value["enabled"]) != "no") {
        printf "Types: deb-src\nSuites:%s\n%s\n", wanted, rest
      }
      split("", value); rest = ""; name = ""
    }
    /^[ \t]*$/ { emit(); next }
    /^#/       { next }
    /^[^ \t]/  {
      name = tolower($0); sub(/:.*/, "", name)
      text = $0; sub(/^[^:]*:[ \t]*/, "", text); value[name] = text
    }
    /^[ \t]/   { value[name] = value[name] " " $0 }
    name != "types" && name != "suites" { rest = rest $0 "\n" }
    END { emit() }' "$file" >>"$private/sources/stanzas.sources"
done
[ -s "$private/sources/lines.list" ] || [ -s "$private/sources/stanzas.sources" ] ||
  cannot "no package source of this machine is known for $package $version, so its source package cannot be found."

apt() {
  apt-get -q -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$private/sources" \
    -o "Dir::State::lists=$private/lists" -o "Dir::Cache=$private/cache" \
    -o APT::Get::List-Cleanup=0 -o "APT::Sandbox::User=$(id -un)" "$@"
}
apt update >"$private/log" 2>&1 || :
(cd "$private/download" && apt source --download-only "catch2=$version") >>"$private/log" 2>&1 || {
  tail -n 5 "$private/log" >&2
  cannot "the source package of Catch2 $version could not be downloaded (the reason stands above); is the network there?"
}

set -- "$private"/download/catch2_*.orig.tar.*
mkdir -p "$target"
tar -xf "$1" -C "$target" --wildcards --strip-components=1 '*/extras/catch_amalgamated.*' '*/LICENSE.txt' ||
  cannot "the source package of Catch2 $version has no extras/catch_amalgamated.cpp."
printf '%s\n' "$version" >"$target/VERSION"
rm -rf "$private"
printf 'Catch2 %s: %s\n' "$version" "$target/extras" >&2
