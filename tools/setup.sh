# shellcheck shell=sh
# Sourced by ./contact, which defines root, say and fail. `setup program|book|test|benchmarks` installs what is missing for
# that level and those below it; only the peers of the benchmarks are no part of `test`. Nothing is installed, and no network touched, when nothing is missing.
: "${root:?this file is sourced by ./contact}"

# level|Debian package|how to see that it is there|Homebrew|what it is
setup_table() {
  cat <<'END'
program|g++|command g++ c++|gcc|a C++20 compiler: g++ 12 or newer, or clang 16 or newer
program|cmake|command cmake|cmake|CMake 3.25 or newer, which describes the build
program|ninja-build|command ninja|ninja|Ninja, which runs the build
program|pkg-config|command pkg-config|pkgconf|pkg-config, which finds libraries
program|mold|command mold|-|mold: links a student's program in a blink
program|libeigen3-dev|header Eigen/Core|eigen|Eigen 3.4: vectors and matrices
program|libcatch2-dev|header catch2/catch_test_macros.hpp|catch2|Catch2 3 (2 is too old): tests
program|libcli11-dev|header CLI/CLI.hpp|cli11|CLI11: the program's command line
program|nlohmann-json3-dev|header nlohmann/json.hpp|nlohmann-json|JSON for Modern C++
program|libtomlplusplus-dev|header toml++/toml.h|tomlplusplus|toml++: reads chapter.toml and its like
program|libuv1-dev|header uv.h|libuv|libuv: processes, time limits and file events
program|libarchive-dev|header archive.h|libarchive|libarchive: reads and writes archives of a reader's work
program|nettle-dev|header nettle/sha2.h|nettle|Nettle: tells by SHA-256 what has changed between two gradings
program|libseccomp-dev|header seccomp.h|-|libseccomp: filters the system calls of submissions
program|bubblewrap|command bwrap|-|bubblewrap: keeps submissions apart from everything else
program|libboost-dev|header boost/multiprecision/gmp.hpp|boost|Boost.Multiprecision: the exact oracle
program|libgmp-dev|header gmp.h|gmp|GMP: integers and fractions of any size
program|libmpfr-dev|header mpfr.h|mpfr|MPFR: directed rounding
program|libmpfi-dev|header mpfi.h|mpfi|MPFI: intervals
program|python3|python|python|Python 3.11 or newer: writes the glue of exercises, runs Sphinx
program|python3-venv|venv|python|Python's venv: keeps this project's Python packages apart
program|ca-certificates|file /etc/ssl/certs/ca-certificates.crt /etc/ssl/cert.pem|ca-certificates|certificates, to fetch packages
book|doxygen|command doxygen|doxygen|Doxygen: reads the headers' comments
book|nodejs|node|node|Node 18 or newer: builds the page's scripts
book|npm|command npm|node|npm: fetches the page's packages
book|dpkg-dev|command dpkg-source|-|dpkg-source: unpacks Catch2's source for the page
test|slurm-wlm|command slurmctld|-|Slurm: the tests grade on a cluster of two nodes on this machine
test|munge|command munged|-|MUNGE: vouches for Slurm's messages
test|git|command git|git|Git: the checks look only at files that are in it
test|clang-tidy|command clang-tidy|llvm|clang-tidy: a second reading of the C++
test|shellcheck|command shellcheck|shellcheck|ShellCheck: the same for shell scripts
test|valgrind|command valgrind|-|Valgrind: counts the instructions of a run
benchmarks|libcgal-dev|header CGAL/version.h|cgal|CGAL: hulls, polygons, rays, meshes, triangle pairs, bounding volumes and broad phase, decided exactly
benchmarks|libqhull-dev|header libqhull_r/qhull_ra.h|qhull|Qhull: convex hulls
benchmarks|libbullet-dev|header bullet/btBulletDynamicsCommon.h|bullet|Bullet: convex hulls, bounding volumes, broad phase, pairs of convex bodies, times of impact and scenes
benchmarks|libode-dev|header ode/ode.h|ode|ODE: scenes, broad phase and pairs of convex bodies
benchmarks|libccd-dev|header ccd/ccd.h|libccd|libccd: pairs of convex bodies
benchmarks|cargo|command cargo|rust|Cargo: unpacks the sources of Box3D, Box2D 3 and Jolt, for broad phase, pairs of convex bodies, times of impact and contacts
benchmarks|libbox2d-dev|header box2d/box2d.h|box2d|Box2D: scenes in the plane and times of impact
benchmarks|libgeos++-dev|header geos/algorithm/PointLocation.h|geos|GEOS: points in polygons
benchmarks|libembree-dev|header embree3/rtcore.h embree4/rtcore.h|embree|Embree 3: rays
benchmarks|libfcl-dev|header fcl/fcl.h|fcl|FCL: segments, meshes, triangle pairs, broad phase, pairs of convex bodies and times of impact
END
}

setup_header_there() {
  for setup_dir in /usr/include /usr/include/eigen3 /usr/include/*-linux-gnu* /usr/local/include \
    /usr/local/include/eigen3 /opt/homebrew/include /opt/homebrew/include/eigen3 /opt/local/include \
    /opt/local/include/eigen3 /usr/local/opt/libarchive/include /opt/homebrew/opt/libarchive/include; do
    [ -e "$setup_dir/$1" ] && return
  done
  return 1
}

# Is what a row of the table asks for there?
setup_there() {
  # shellcheck disable=SC2086 # the row's words
  set -- $1
  kind=$1
  shift
  case $kind in
    command) for setup_word in "$@"; do command -v "$setup_word" > /dev/null 2>&1 && return; done; return 1 ;;
    header) for setup_word in "$@"; do setup_header_there "$setup_word" && return; done; return 1 ;;
    file) for setup_word in "$@"; do [ -e "$setup_word" ] && return; done; return 1 ;;
    node) command -v node > /dev/null 2>&1 && node -e 'process.exit(parseInt(process.versions.node) < 18 ? 1 : 0)' ;;
    python) setup_new_enough python3 ;;
    venv) "$(setup_python)" -c 'import ensurepip, venv' > /dev/null 2>&1 ;;
  esac
}

setup_new_enough() {
  "$1" -c 'import sys; sys.exit(sys.version_info < (3, 11))' > /dev/null 2>&1
}

# Other users cannot use a Python in root's home, but the system's Python works for all who grade here.
setup_python() {
  case $(id -u):$(python3 -c 'import sys; print(sys.base_prefix)' 2> /dev/null) in
    0:"${HOME:-/root}"/*)
      if setup_new_enough /usr/bin/python3; then
        echo /usr/bin/python3
        return
      fi
      ;;
  esac
  echo python3
}

setup_at_or_below() {
  case $2 in
    test) [ "$1" != benchmarks ] ;;
    benchmarks) [ "$1" != test ] ;;
    book) [ "$1" = program ] || [ "$1" = book ] ;;
    program) [ "$1" = program ] ;;
  esac
}

# The rows of the table that are wanted and missing.
setup_missing() {
  setup_table | while IFS='|' read -r level package look brew what; do
    setup_at_or_below "$level" "$1" || continue
    # Without a name for Homebrew: wanted only where there is apt.
    [ "$brew" != - ] || command -v apt-get > /dev/null 2>&1 || continue
    setup_there "$look" || printf '%s|%s|%s\n' "$package" "$brew" "$what"
  done
}

setup_browser() {
  for setup_word in chromium chromium-browser google-chrome google-chrome-stable; do
    if setup_path=$(command -v "$setup_word" 2> /dev/null); then
      # Ubuntu's chromium-browser is a script that sends one to a snap.
      grep -q 'snap install' "$setup_path" 2> /dev/null || return 0
    fi
  done
  [ -x '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome' ]
}

setup_release() { # a field of /etc/os-release, or nothing
  # The file is itself shell, so its quotes are the shell's to undo.
  [ ! -r /etc/os-release ] || sh -c '. /etc/os-release && eval "printf %s \"\${$1-}\""' sh "$1"
}

setup_system() { # Debian 12 -> "debian 12"
  printf '%s %s' "$(setup_release ID)" "$(setup_release VERSION_ID)"
}

setup_as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null 2>&1; then
    # Without a terminal no password can be typed: fail at once instead of waiting for one.
    if [ -t 0 ]; then sudo "$@"; else sudo -n "$@"; fi
  else
    fail 3 "installing packages takes root, and there is no sudo. As root, run: ./contact setup"
  fi
}

setup_candidate() {
  apt-cache policy "$1" 2> /dev/null | sed -n 's/^  Candidate: //p' | sed 's/^(none)$//'
}

setup_log=''
setup_unreachable() { # does the log say that a server could not be reached?
  grep -qiE 'could ?n.t connect|could not connect|unable to connect|failed to fetch|could not resolve|temporary failure|connection refused|connection timed out|connection failed|network is unreachable|newconnectionerror|connecttimeout|max retries|proxyerror|econnrefused|enotfound|eai_again|etimedout|econnreset|err_socket|no route to host|ssl: certificate|unable_to_get_issuer' "$setup_log"
}

setup_apt_update() {
  setup_as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=1 \
    -o APT::Update::Error-Mode=any update >> "$setup_log" 2>&1 < /dev/null
}

# A sources file of our own: the machine's own server, another suite or component.
setup_add_sources() { # name, suites, components, keyring
  setup_codename=$(setup_release VERSION_CODENAME)
  # shellcheck disable=SC2016 # apt's own variables
  setup_uri=$(apt-get indextargets --format '$(CODENAME)|$(LABEL)|$(REPO_URI)' 'Created-By: Packages' 2> /dev/null |
    sed -n -E "s/^$setup_codename\\|(Debian|Ubuntu)\\|//p" | head -n 1)
  [ -n "$setup_uri" ] || fail 3 "cannot tell from which server this machine takes its packages; enable $2 ($3) by hand, \
then run ./contact setup again"
  setup_file=/etc/apt/sources.list.d/contact-hours-$1.sources
  say "Writing $setup_file (packages from $2)"
  printf '# Written by ./contact setup of Contact Hours. Remove it to undo.\nTypes: deb deb-src\nURIs: %s\nSuites: %s\nComponents: %s\nSigned-By: %s\n' \
    "$setup_uri" "$2" "$3" "$4" | setup_as_root tee "$setup_file" > /dev/null
}

# Catch2 3 goes by two names. Prints the one whose candidate is new enough, or nothing.
setup_catch2() {
  for setup_word in libcatch2-dev catch2; do
    setup_version=$(setup_candidate "$setup_word")
    if [ -n "$setup_version" ] && dpkg --compare-versions "$setup_version" ge 3; then
      printf '%s' "$setup_word"
      return
    fi
  done
}

setup_apt() { # the packages that are missing
  setup_log=$root/build/logs/setup-apt.log
  mkdir -p "$root/build/logs"
  : > "$setup_log"
  # Fail before anything is written when we cannot become root.
  setup_as_root true || fail 3 "installing Debian packages takes root; run it where sudo can ask, or as root. \
Wanted:$(printf ' %s' "$@")"
  setup_updated=no
  say "Asking apt for its newest lists"
  setup_apt_update && setup_updated=yes

  case $(setup_system) in
    ubuntu*)
      if [ -z "$(setup_candidate libcli11-dev)" ]; then
        setup_add_sources universe "$(setup_release VERSION_CODENAME)" universe /usr/share/keyrings/ubuntu-archive-keyring.gpg
        setup_apt_update || setup_updated=no
      fi
      ;;
  esac

  setup_packages=''
  for setup_package in "$@"; do
    if [ "$setup_package" = libcatch2-dev ]; then
      setup_name=$(setup_catch2)
      if [ -z "$setup_name" ] && [ "$(setup_system)" = 'debian 12' ]; then
        if [ ! -e /etc/apt/sources.list.d/contact-hours-backports.sources ]; then
          setup_add_sources backports bookworm-backports main /usr/share/keyrings/debian-archive-keyring.gpg
          setup_updated=no
          setup_apt_update && setup_updated=yes
        fi
        setup_name=$(setup_catch2)
      fi
      setup_package=$setup_name
      if [ -z "$setup_name" ]; then
        [ "$setup_updated" = yes ] || setup_fail_apt
        fail 3 "Catch2 3 is not among this system's packages. Debian 12, Debian 13 and Ubuntu 24.04 have it; elsewhere \
install it from its source, then run ./contact setup again"
      fi
    elif [ -z "$(setup_candidate "$setup_package")" ]; then
      [ "$setup_updated" = yes ] || setup_fail_apt
      fail 3 "there is no package $setup_package in this system's lists. Debian 12, Debian 13 and Ubuntu 24.04 have it"
    fi
    setup_packages="$setup_packages $setup_package"
  done

  say "Installing Debian packages:$setup_packages"
  # shellcheck disable=SC2086 # a list of names
  if ! setup_as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 \
    -o Acquire::Retries=2 install --no-install-recommends $setup_packages >> "$setup_log" 2>&1 < /dev/null; then
    setup_fail_apt
  fi
}

setup_fail_apt() {
  tail -n 8 "$setup_log" >&2
  if setup_unreachable; then
    fail 3 "the Debian packages are out of reach: apt could not connect to its server. Check the network (and the \
proxy, if apt uses one), then run ./contact setup again. All of apt's words: $setup_log"
  fi
  fail 3 "apt could not install the Debian packages. Its own words are above; all of them: $setup_log"
}

setup_by_hand() { # the missing rows on standard input
  setup_brew=''
  say "This system has no apt, so please install these yourself, then run the same command again:"
  while IFS='|' read -r package brew what; do
    say "  $what"
    case " $setup_brew - " in *" $brew "*) ;; *) setup_brew="$setup_brew $brew" ;; esac
  done
  if command -v brew > /dev/null 2>&1; then say "With Homebrew: brew install$setup_brew"; fi
  exit 3
}

setup_venv() { # the folder of requirements.txt, and the one of build/ where what it pins goes
  setup_pins=$root/$1/requirements.txt
  setup_place=$root/build/$2
  [ -f "$setup_pins" ] || return 0
  setup_stamp=$setup_place/contact-requirements.txt
  if cmp -s "$setup_pins" "$setup_stamp" && "$setup_place/bin/python" -c '' 2> /dev/null; then
    return 0
  fi
  say "Installing the Python packages of $1/requirements.txt into build/$2:" \
    "$(sed -n 's/^\([A-Za-z0-9._-]*==[^ ;\\]*\).*/\1/p' "$setup_pins" | tr '\n' ' ')"
  setup_log=$root/build/logs/setup-python.log
  mkdir -p "$root/build/logs"
  rm -rf "$setup_place"
  if ! {
    "$(setup_python)" -m venv "$setup_place" &&
      "$setup_place/bin/python" -m pip install --disable-pip-version-check --no-input --retries 2 \
        -r "$setup_pins"
  } > "$setup_log" 2>&1 < /dev/null; then
    tail -n 8 "$setup_log" >&2
    if setup_unreachable; then
      fail 3 "the Python packages are out of reach: pip could not connect to the package index. Check the network, or \
point pip at a mirror with PIP_INDEX_URL, then run ./contact setup again. All of pip's words: $setup_log"
    fi
    fail 3 "pip could not install the Python packages. Its own words are above; all of them: $setup_log"
  fi
  cp "$setup_pins" "$setup_stamp"
}

setup_npm() { # the folder of package-lock.json
  setup_pins=$root/$1/package-lock.json
  [ -f "$setup_pins" ] || return 0
  setup_stamp=$root/$1/node_modules/.contact-package-lock.json
  cmp -s "$setup_pins" "$setup_stamp" && return 0
  say "Installing the npm packages of $1/package-lock.json into $1/node_modules:" \
    "$(sed -n '/"\(dependencies\|devDependencies\)": {/,/}/s/^ *"\([^"]*\)": "\([0-9][^"]*\)".*/\1@\2/p' \
      "$root/$1/package.json" | tr '\n' ' ')"
  setup_log=$root/build/logs/setup-npm.log
  mkdir -p "$root/build/logs"
  if ! (cd "$root/$1" && npm ci --no-audit --no-fund --fetch-retries=1 --fetch-retry-mintimeout=2000) \
    > "$setup_log" 2>&1 < /dev/null; then
    tail -n 8 "$setup_log" >&2
    if setup_unreachable; then
      fail 3 "the npm packages are out of reach: npm could not connect to its registry. Check the network (and \
\`npm config get proxy\`), then run ./contact setup again. All of npm's words: $setup_log"
    fi
    fail 3 "npm could not install its packages. Its own words are above; all of them: $setup_log"
  fi
  cp "$setup_pins" "$setup_stamp"
}

setup_cargo_reads() { # can Cargo read a folder's packages? rust-version in Cargo.toml says which it takes: 1.85
  setup_wants=$(sed -n 's/^rust-version = "1\.\([0-9]*\)".*/\1/p' "$root/$1/Cargo.toml")
  [ -n "$setup_wants" ] || return 0
  setup_has=$(cargo --version | sed -n 's/^cargo [01]\.\([0-9]*\)\..*/\1/p')
  [ "${setup_has:-0}" -ge "$setup_wants" ]
}

setup_crates() { # the folder of Cargo.lock
  setup_pins=$root/$1/Cargo.lock
  [ -f "$setup_pins" ] || return 0
  setup_stamp=$root/build/crates/contact-$(basename "$1")-Cargo.lock
  cmp -s "$setup_pins" "$setup_stamp" && return 0
  if ! setup_cargo_reads "$1"; then
    say "$(cargo --version) cannot read the packages of $1/Cargo.toml: they take Cargo 1.$setup_wants. They are left out."
    return 0
  fi
  say "Unpacking the sources of $1/Cargo.toml into build/crates:" \
    "$(sed -n 's/^\([a-z0-9_-]*\) = "=\([0-9][^"]*\)".*/\1@\2/p' "$root/$1/Cargo.toml" | tr '\n' ' ')"
  setup_log=$root/build/logs/setup-crates.log
  mkdir -p "$root/build/logs" "$root/build/crates"
  if ! CARGO_HOME=$root/build/crates cargo fetch --locked --manifest-path "$root/$1/Cargo.toml" \
    > "$setup_log" 2>&1 < /dev/null; then
    tail -n 8 "$setup_log" >&2
    if setup_unreachable; then
      fail 3 "the packages of Cargo are out of reach: it could not connect to its registry. Check the network, then run \
./contact setup again. All of Cargo's words: $setup_log"
    fi
    fail 3 "Cargo could not unpack its packages. Its own words are above; all of them: $setup_log"
  fi
  cp "$setup_pins" "$setup_stamp"
}

setup() {
  setup_rows=$(setup_missing "$1")
  setup_wanted=$(printf '%s\n' "$setup_rows" | cut -d '|' -f 1)
  if [ "$1" = test ] && ! setup_browser; then
    case $(setup_system) in
      debian*) setup_wanted="$setup_wanted chromium fonts-dejavu-core" ;;
      *) say "No browser is set up here (Ubuntu's Chromium is a snap; Chrome would do): browser tests will be reported as not run." ;;
    esac
  fi
  # shellcheck disable=SC2086 # a list of names
  set -- "$1" $setup_wanted
  setup_level=$1
  shift
  if [ $# -gt 0 ]; then
    if command -v apt-get > /dev/null 2>&1; then
      setup_apt "$@"
      setup_rows=$(setup_missing "$setup_level")
      [ -z "$setup_rows" ] || fail 3 "still missing or too old after installing:$(
        printf '%s\n' "$setup_rows" | cut -d '|' -f 3 | sed 's/^/ /' | tr '\n' ';'
      ) look for another version earlier in PATH"
    elif [ -n "$setup_rows" ]; then
      printf '%s\n' "$setup_rows" | setup_by_hand
      exit 3
    fi
  fi
  setup_venv docs venv
  if [ "$setup_level" != program ]; then
    setup_venv page venv-page
    setup_npm page
  fi
  if [ "$setup_level" = benchmarks ]; then
    setup_venv benchmarks venv-benchmarks
    setup_npm benchmarks
    setup_crates benchmarks/crates
    setup_crates benchmarks/crates/box2d
  fi
}
