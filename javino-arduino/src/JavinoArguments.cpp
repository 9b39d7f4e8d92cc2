#ifdef ARDUINO /* on other systems, only the core in C is used */

#include "JavinoArguments.h"

#include <float.h>

#include "javino_literal.h"

namespace {

/** Iterates over the characters of an argument. Skips quotes and escapes. */
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

#ifndef JAVINO_NO_DECIMALS
/** A number as a mantissa with the digits of a double, and a power of ten. */
class Decimal {
public:
  Decimal() : mantissa_(0), digits_(0), exponent_(0) {}

  /** Appends the digits at the beginning of the text. @return the number of digits */
  uint8_t append(const char **text, const char *end, bool decimals) {
    uint8_t n = 0;
    for (; *text < end && **text >= '0' && **text <= '9'; n++, (*text)++) {
      bool dropped = mantissa_ >= LIMIT;
      exponent_ += dropped - decimals;
      if (dropped)
        continue;
      mantissa_ = mantissa_ * 10 + static_cast<uint8_t>(**text - '0');
      digits_ += mantissa_ != 0;
    }
    return n;
  }

  void multiplyByPowerOfTen(int32_t exponent) {
    exponent_ += static_cast<int16_t>(exponent < -MOST ? -MOST : exponent > MOST ? MOST : exponent);
  }

  /** Returns true if the number is in the range of a double, or too small for it. */
  bool fits() const { return mantissa_ == 0 || digits_ + exponent_ <= DBL_MAX_10_EXP; }

  /** Returns the value of a number that fits. Returns 0 for a number that is too small. */
  double value() const {
    double power = 1;
    /* A power that is too large becomes infinity. A number divided by infinity is 0. */
    for (int16_t n = exponent_ < 0 ? -exponent_ : exponent_; mantissa_ && n > 0; n--)
      power *= 10;
    return exponent_ < 0 ? mantissa_ / power : mantissa_ * power;
  }

private:
#if DBL_MAX_10_EXP < 100
  typedef uint32_t Mantissa;
#else
  typedef uint64_t Mantissa;
#endif
  static const Mantissa LIMIT = static_cast<Mantissa>(-1) / 10 - 1;
  static const int16_t MOST = 400;

  Mantissa mantissa_;
  uint8_t digits_; /* number of digits of the mantissa */
  int16_t exponent_;
};
#endif

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

#ifndef JAVINO_NO_DECIMALS
double JavinoArguments::decimal(uint8_t index, double otherwise) const {
  const char *text;
  uint8_t bytes = javino_argument(literal_, length_, index, &text);
  if (!bytes)
    return otherwise;
  const char *end = text + bytes;
  bool negative = *text == '-';
  text += negative || *text == '+';
  Decimal decimal;
  bool whole = decimal.append(&text, end, false);
  if (text < end && *text == '.')
    whole = whole && decimal.append(&++text, end, true);
  if (whole && text < end && (*text | 0x20) == 'e') {
    int32_t exponent = 0;
    whole = javino_number(text + 1, static_cast<uint8_t>(end - text - 1), &exponent);
    text = end;
    decimal.multiplyByPowerOfTen(exponent);
  }
  if (!whole || text < end || !decimal.fits())
    return otherwise;
  double value = decimal.value();
  return negative ? -value : value;
}
#endif

bool JavinoArguments::is(uint8_t index, const char *text) const {
  Characters characters(literal_, length_, index);
  while (characters.more())
    if (*text == 0 || characters.take() != *text++)
      return false;
  return *text == 0 && index < count();
}

bool JavinoArguments::is(uint8_t index, const __FlashStringHelper *text) const {
  JAVINO_COPY(copy, text);
  return is(index, copy);
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

#endif
