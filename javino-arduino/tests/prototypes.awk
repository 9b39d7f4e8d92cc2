# Does what the Arduino tools do to a sketch before it is compiled: declares its functions ahead of the first one. Takes the sketch twice.
# A definition is found wherever it stands outside of braces, also if its head has several lines.
FNR == NR { text = text "\n" $0; next }
FNR == 1 {
  findFunctions()
  print "#include <Arduino.h>\n#line 1 \"" FILENAME "\""
}
FNR == first { printf "%s#line %d \"%s\"\n", declarations, FNR, FILENAME }
{ print }

# Between the tokens is code. Comments, texts in quotes and lines of the preprocessor count as tokens, since their brackets are no code.
function findFunctions(    token, head, line, depth) {
  while (match(text, /\/\/[^\n]*|\/\*([^*]|\*+[^*\/])*\*+\/|R"[A-Za-z0-9_]*\(|"([^"\\\n]|\\.)*"|'([^'\\\n]|\\.)*'|\n[ \t]*#([^\\\n]|\\\r?\n|\\.)*|[{};]/)) {
    token = substr(text, RSTART, RLENGTH)
    head = head substr(text, 1, RSTART - 1)
    text = substr(text, RSTART + RLENGTH)
    if (token ~ /^R/)
      token = token rawText(")" substr(token, 3, RLENGTH - 3) "\"")
    if (token !~ /^[{};]$/) {
      head = head (token ~ /^["'R]/ ? "\"" : " ") breaks(token)
      depth = inBranch(token, depth)
      continue
    }
    if (token == "{" && depth++ == 0)
      declare(head, line)
    else if (token == "}" && depth > 0)
      depth--
    line += length(breaks(head))
    head = ""
  }
}

# Returns how deep in braces the code behind `token` is: each branch of an #if begins as deep as the first.
function inBranch(token, depth) {
  if (token ~ /^\n[ \t]*#[ \t]*if/)
    before[++branches] = depth
  else if (token ~ /^\n[ \t]*#[ \t]*el/)
    depth = before[branches]
  else if (token ~ /^\n[ \t]*#[ \t]*endif/)
    branches--
  return depth
}

# Takes a raw text in quotes to its end.
function rawText(end,    place, raw) {
  place = index(text, end)
  raw = place ? substr(text, 1, place + length(end) - 1) : text
  text = substr(text, length(raw) + 1)
  return raw
}

function breaks(code) {
  gsub(/[^\n]+/, "", code)
  return code
}

# Declares the function with this head, if it is one; `line` is the number of the line before the head.
function declare(head, line,    blanks) {
  blanks = head
  sub(/[^ \t\r\n](.|\n)*/, "", blanks)
  gsub(/[ \t\r\n]+/, " ", head)
  gsub(/^ | $/, "", head)
  if (head !~ /^[A-Za-z_][A-Za-z0-9_ *&]*[ *&][A-Za-z_][A-Za-z0-9_]* ?\([^={"]*\)$/ || head ~ /^(else|return|template|struct|class|typedef)/)
    return
  declarations = declarations head ";\n"
  if (!first)
    first = line + length(breaks(blanks))
}
