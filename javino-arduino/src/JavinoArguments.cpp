#include "JavinoArguments.h"

#include <stdlib.h>

#include "javino_literal.h"

namespace {

/** Walks over the characters of an argument as they were meant: without quotes and escapes. */
class Characters {
public:
  Characters(const char *literal, uint8_t length, uint8_t index) : next_(literal) {
    uint8_t bytes = javino_argument(literal, length, index, &next_);
    end_ = next_ + bytes;
    quoted_ = bytes >= 2 && *next_ == '"' && end_[-1] == '"';
    if (quoted_) {
      next_++;
      end_--;
    }
  }

  bool more() const { return next_ < end_; }

  char take() {
    if (!quoted_ || *next_ != '\\' || next_ + 1 == end_)
      return *next_++;
    next_ += 2;
    return next_[-1] == 'n' ? '\n' : next_[-1] == 't' ? '\t' : next_[-1];
  }

private:
  const char *next_;
  const char *end_;
  bool quoted_;
};

}  // namespace

uint8_t JavinoArguments::count() const {
  const char *argument;
  uint8_t n = 0;
  while (javino_argument(literal_, length_, n, &argument))
    n++;
  return n;
}

bool JavinoArguments::isNumber(uint8_t index) const {
  const char *argument;
  int32_t value;
  uint8_t bytes = javino_argument(literal_, length_, index, &argument);
  return bytes && javino_number(argument, bytes, &value);
}

long JavinoArguments::number(uint8_t index, long otherwise) const {
  const char *argument;
  int32_t value;
  uint8_t bytes = javino_argument(literal_, length_, index, &argument);
  return bytes && javino_number(argument, bytes, &value) ? value : otherwise;
}

double JavinoArguments::decimal(uint8_t index, double otherwise) const {
  char digits[32];
  char *end;
  size_t bytes = copy(index, digits, sizeof digits);
  double value = strtod(digits, &end);
  return bytes && bytes < sizeof digits && *end == 0 ? value : otherwise;
}

bool JavinoArguments::is(uint8_t index, const char *text) const {
  Characters characters(literal_, length_, index);
  while (characters.more())
    if (*text == 0 || characters.take() != *text++)
      return false;
  return *text == 0 && index < count();
}

size_t JavinoArguments::copy(uint8_t index, char *to, size_t size) const {
  Characters characters(literal_, length_, index);
  size_t n = 0;
  for (; characters.more(); n++) {
    char c = characters.take();
    if (n + 1 < size)
      to[n] = c;
  }
  if (size)
    to[n < size ? n : size - 1] = 0;
  return n;
}

String JavinoArguments::text(uint8_t index) const {
  Characters characters(literal_, length_, index);
  String text;
  while (characters.more())
    text += characters.take();
  return text;
}
