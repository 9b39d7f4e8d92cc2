# shellcheck shell=bash
# What the checks of the boards' modules share: steps that run quietly, what they measured, what is left out. For ". steps.bash" in the
# folder of the module.
mkdir -p build
log=$PWD/build/check.log
: > "$log"
failed=0
figures=()
left_out=()

has() { command -v "$1" > /dev/null; }

leave_out() { left_out+=("$1: $2"); }

# step NAME COMMAND...: runs it; lines of its output that begin with two spaces are figures.
step() {
  local name=$1 begin=$SECONDS
  shift
  printf '%-52s' "$name"
  if { echo "== $name: $*"; "$@" 2>&1; } > build/step.log; then
    printf 'ok   %4d s\n' $((SECONDS - begin))
    while IFS= read -r line; do figures+=("$line"); done < <(grep -E '^  [^ ]' build/step.log)
  else
    printf 'FAIL\n'
    tail -n 25 build/step.log | sed 's/^/    /'
    failed=1
  fi
  cat build/step.log >> "$log"
}

# finish [ADVICE]: shows what was measured and left out, and ends.
finish() {
  [ ${#figures[@]} -eq 0 ] || printf '%s\n' '' 'figures' "${figures[@]}"
  [ ${#left_out[@]} -eq 0 ] || printf '%s\n' '' 'left out' "${left_out[@]/#/  }" ${1:+"  $1"}
  printf '\nlog: %s\n' "$log"
  exit $failed
}

# usage: shows the comment at the beginning of the script, and ends.
usage() {
  sed -n '2,/^[^#]/{/^#/s/^# \{0,1\}//p}' "$0"
  exit 2
}
