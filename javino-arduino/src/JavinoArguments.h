#ifndef JAVINO_ARGUMENTS_H
#define JAVINO_ARGUMENTS_H

#include <Arduino.h>
#include <string.h>

/** Declares `copy`, a copy of a text in flash. The copy is on the stack, not on the heap. */
#define JAVINO_COPY(copy, in_flash) \
  char copy[strlen_P(reinterpret_cast<const char *>(in_flash)) + 1]; \
  memcpy_P(copy, reinterpret_cast<const char *>(in_flash), sizeof copy)

/**
 * The arguments of an action in order. In `move(left, 30)` argument 0 is the atom `left`, and argument 1 is the number 30. Valid only
 * while the action's function runs.
 */
class JavinoArguments {
public:
  /** The arguments of a well-formed literal. The text is not copied. */
  JavinoArguments(const char *literal, uint8_t length) : literal_(literal), length_(length) {}

  /** The number of arguments. */
  uint8_t count() const;

  /** Returns true if the argument is a whole number that fits into a long. */
  bool isNumber(uint8_t index) const;

  /** Returns the argument if it is a whole number that fits into a long, else `otherwise`. */
  long number(uint8_t index, long otherwise = 0) const;

#ifndef JAVINO_NO_DECIMALS
  /** Returns the argument if it is a number, with or without decimals and exponent, else `otherwise`. Never returns infinity or NaN. */
  double decimal(uint8_t index, double otherwise = 0) const;
#endif

  /** Returns true if the argument is this atom or string. */
  bool is(uint8_t index, const char *text) const;
  bool is(uint8_t index, const __FlashStringHelper *text) const;

  /**
   * Copies an argument and ends the copy with a zero. A string is copied without its quotes.
   *
   * @param size  the size of `to` in bytes; a longer text is truncated
   * @return the length of the whole argument, without the zero; 0: there is no such argument
   */
  size_t copy(uint8_t index, char *to, size_t size) const;

  /** Returns the argument's text. A string is returned without its quotes. Uses the heap. */
  String text(uint8_t index) const;

private:
  const char *literal_;
  uint8_t length_;
};

#endif
