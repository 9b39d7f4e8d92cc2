#include "JavinoArguments.h"

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

/** Reads the digits of a number that begin here. */
class Digits {
public:
  Digits(const char *text, const char *end) : next_(text), end_(end) {}

  bool take(char c) { return next_ < end_ && *next_ == c && next_++; }

  bool takeSign() {
    bool negative = take('-');
    if (!negative)
      take('+');
    return negative;
  }

  /** Appends the digits to a value. @return how many there are */
  uint8_t append(double *value) {
    uint8_t n = 0;
    for (; next_ < end_ && *next_ >= '0' && *next_ <= '9'; n++)
      *value = *value * 10 + (*next_++ - '0');
    return n;
  }

  bool atEnd() const { return next_ == end_; }

private:
  const char *next_;
  const char *end_;
};

bool isFinite(double value) {
  return value - value == 0;
}

/** Ten to this power, or infinity. */
double powerOfTen(double exponent) {
  double power = 1;
  for (; exponent >= 1 && isFinite(power); exponent--)
    power *= 10;
  return power;
}

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
  const char *text;
  uint8_t bytes = javino_argument(literal_, length_, index, &text);
  if (!bytes)
    return otherwise;
  Digits digits(text, text + bytes);
  double value = 0;
  double exponent = 0;
  uint8_t decimals = 0;
  bool negative = digits.takeSign();
  bool whole = digits.append(&value) && (!digits.take('.') || (decimals = digits.append(&value)));
  if (whole && (digits.take('e') || digits.take('E'))) {
    bool smaller = digits.takeSign();
    whole = digits.append(&exponent);
    if (smaller)
      exponent = -exponent;
  }
  exponent -= decimals;
  if (value != 0)
    value = exponent < 0 ? value / powerOfTen(-exponent) : value * powerOfTen(exponent);
  if (!whole || !digits.atEnd() || !isFinite(value))
    return otherwise;
  return negative ? -value : value;
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
