# Does what the Arduino tools do to a sketch before it is compiled: declares its functions ahead of the first one.
# Only definitions that begin in the first column and on one line are found.
FNR == NR {
  if ($0 ~ /^[A-Za-z_][A-Za-z0-9_ *&]*[ *&][A-Za-z_][A-Za-z0-9_]*[ \t]*\([^;={]*\)[ \t\r]*((\{|\/\/|\/\*).*)?$/ && $0 !~ /^(else|return|static|template|struct|class|typedef)/) {
    declaration = $0
    sub(/\)[ \t\r]*((\{|\/\/|\/\*).*)?$/, ");", declaration)
    declarations = declarations declaration "\n"
    if (!first)
      first = FNR
  }
  next
}
FNR == 1 { print "#include <Arduino.h>\n#line 1 \"" FILENAME "\"" }
FNR == first { printf "%s#line %d \"%s\"\n", declarations, FNR, FILENAME }
{ print }
