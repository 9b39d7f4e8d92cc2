# shellcheck shell=bash
# Functions for the scripts of ./argo: messages, required tools, Maven. A script includes them with ". build-tools/common.bash".
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$here/.argo
jar=$here/argo-jar/target/argo.jar

fail() { printf './argo: %s\n' "$*" >&2; exit 1; }
misuse() { printf './argo: %s\n' "$*" >&2; exit 2; }

# Ends with a message unless there are a JDK and a Maven that can build ARGO. Maven must also run on a JDK that can build ARGO.
need_tools() {
  command -v javac >/dev/null 2>&1 || fail 'no JDK found (no javac on the PATH).' \
    'ARGO needs a JDK, 17 or newer: "sudo apt install default-jdk", "brew install openjdk" or https://adoptium.net'
  local javac java
  javac=$(javac -version 2>&1) || fail "the JDK on the PATH does not run, ARGO needs 17 or newer: https://adoptium.net. javac says: $javac"
  java=$(sed -n 's/^javac \([0-9]*\).*/\1/p' <<<"$javac")
  [ "${java:-0}" -ge 17 ] ||
    fail "the JDK on the PATH is $javac, ARGO needs 17 or newer: https://adoptium.net, then put its bin directory first on the PATH"
  command -v mvn >/dev/null 2>&1 || fail 'no Maven found. ARGO needs Maven, 3.8 or newer:' \
    '"sudo apt install maven", "brew install maven" or https://maven.apache.org/download.html'
  local mvn maven major minor; mvn=$(mvn --version 2>&1) || fail "Maven does not run${JAVA_HOME:+ with JAVA_HOME=$JAVA_HOME}. It says: $mvn"
  maven=$(sed -n 's/.*Apache Maven \([0-9.]*\).*/\1/p' <<<"$mvn" | head -n 1)
  IFS=. read -r major minor _ <<<"$maven"
  [ "${major:-0}" -gt 3 ] || { [ "${major:-0}" -eq 3 ] && [ "${minor:-0}" -ge 8 ]; } ||
    fail "Maven on the PATH is ${maven:-of no known version}, ARGO needs 3.8 or newer: https://maven.apache.org/download.html"
  java=$(sed -n 's/.*Java version: \([0-9]*\).*/\1/p' <<<"$mvn" | head -n 1)
  [ "${java:-17}" -ge 17 ] ||
    fail "Maven runs on Java $java, ARGO needs 17 or newer: have JAVA_HOME name such a JDK (now: ${JAVA_HOME:-not set})"
}

# Shows the lines of the input. A terminal shows only the newest line.
show_one_line() {
  local line
  while IFS= read -r line; do if [ -t 2 ]; then printf '\r\033[K%s' "$line"; else printf '%s\n' "$line"; fi; done
}

# maven LOG ARGUMENT…: runs Maven. Writes Maven's output to LOG, and shows the current module on the terminal.
maven() {
  local log=$1; shift
  mkdir -p "$logs"
  : >"$log" # now, so that no line of an earlier build is shown
  local status=0
  mvn -B -f "$here/pom.xml" "$@" >"$log" 2>&1 < /dev/null &
  local pid=$!
  tail -n +1 -F --pid=$pid "$log" 2>/dev/null | sed -u -n 's/^\[INFO\] Building \([a-z-]*\) .*\[\(.*\)\]$/  \1 (\2)/p' | show_one_line >&2 &
  local shown=$! # in the background, because a signal interrupts only "wait"
  trap 'kill $pid 2>/dev/null; exit 130' INT
  trap 'kill $pid 2>/dev/null; exit 143' TERM
  wait $pid || status=$?
  wait $shown || true
  [ ! -t 2 ] || printf '\r\033[K' >&2
  trap - INT TERM
  return $status
}

# Prints the errors in Maven's log, without Maven's advice on its options. Adds a remedy if Maven could not fetch something.
errors() {
  sed -nE 's/ *-> \[Help [0-9]+\]$//; /^\[ERROR\] *[^ ]/p' "$1" |
    grep -vE '^\[ERROR\] (\[Help [0-9]|To see the full|Re-run|For more information|After correcting|  mvn <args>|See .*surefire|See dump)' |
    awk '!seen[$0]++ && ++lines <= 25' || true
  if grep -qE '^\[(ERROR|WARNING)\].*(Could not transfer |transfer failed|[Uu]nknown host|Connection refused|No plugin found for prefix)' "$1"; then
    echo 'Maven Central cannot be reached, where the libraries are fetched from.' \
      'Behind a proxy, name it in ~/.m2/settings.xml: https://maven.apache.org/guides/mini/guide-proxies.html'
  fi
}

build_failed() { errors "$1" >&2; fail "the build failed; the whole log is in $1"; }

# Prints the value of a property of the POM, such as argo.group.
property() { sed -n "s|^    <$1>\(.*\)</$1>$|\1|p" "$here/pom.xml"; }

# Prints the folders of the modules.
modules() { sed -n 's|.*<module>\(.*\)</module>.*|\1|p' "$here/pom.xml"; }

# build MODULE…: builds the given modules and their dependencies, without tests. Skips a module if no source has changed since its last
# build.
build() {
  local all module log=$logs/build.log changed=''
  IFS=$'\n' read -r -d '' -a all < <(modules) || true
  all=("${all[@]/#/$here/}") # only modules: a project made by "new" may lie beside them
  local sources=("$here/pom.xml" "${all[@]/%//pom.xml}" "${all[@]/%//src}" "$here/samples" "$here/experiment")
  for module; do
    local stamp=$logs/built-$module
    if [ -f "$stamp" ] && compgen -G "$here/$module/target/*.jar" >/dev/null &&
       [ -z "$(find "${sources[@]}" -path '*/target' -prune -o -type f -newer "$stamp" -print -quit)" ]; then continue; fi
    changed=${changed:+$changed,}$module
  done
  [ -n "$changed" ] || return 0
  echo 'building (the first time fetches about 140 MB of libraries)' >&2
  maven "$log" package -Dmaven.test.skip=true -pl "$changed" -am || build_failed "$log"
  for module in ${changed//,/ }; do touch "$logs/built-$module"; done
}

# Prints the version and the commit of ARGO.
version() {
  local commit; commit=$(git -C "$here" describe --always --dirty --abbrev=10 2>/dev/null) || commit=unknown
  printf '%s, commit %s' "$(sed -n 's|^  <version>\(.*\)</version>$|\1|p' "$here/pom.xml")" "$commit"
}

# run MODULE CLASS ARGUMENT…: runs a program of a module. The program replaces this script.
run() {
  local module=$1; shift
  build "$module"
  # without --enable-native-access, newer Java machines warn of jSerialComm's native library
  exec java "-Dargo.build=$(version)" --enable-native-access=ALL-UNNAMED -cp "$here/$module/target/classes:$(cat "$here/$module/target/run.classpath")" "$@"
}

# Runs the tools in argo.jar. The tools replace this script.
tools() {
  build argo-jar
  exec java "-Dargo.command=./argo tools" -jar "$jar" "$@"
}
