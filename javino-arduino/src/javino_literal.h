/**
 * @file Reads the text of an action: a literal such as ledOn, speed(120) or say("hi; you"). Texts are not terminated. Nothing is copied.
 */
#ifndef JAVINO_LITERAL_H
#define JAVINO_LITERAL_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The open brackets and quotes at a place in a text. Begin with zero in all members. */
typedef struct {
    uint8_t depth;
    char quote; /**< 0 outside of quotes. */
    bool escaped;
    bool crossed;   /**< True if a closing bracket had no opening bracket of its kind. */
    uint32_t kinds; /**< The kinds of the innermost sixteen open brackets, two bits each. */
} javino_nesting;

/** Takes one character. @return true if it is neither a bracket nor a quote, and is outside of both */
bool javino_outside(javino_nesting *nesting, char c);

/** @return the number of bytes before the first bracket, at most length. A zero byte also ends the text */
uint8_t javino_word(const char *text, uint8_t length);

/**
 * @return the length of the literal's functor. 0 if the text is no literal: brackets or quotes are open or cross each other, an argument
 *     is missing, or text other than annotations follows the arguments
 */
uint8_t javino_functor(const char *text, uint8_t length);

/**
 * Finds the argument of a literal with this index, counted from 0. Sets `argument` to its first byte after spaces. @return its length, or
 * 0
 */
uint8_t javino_argument(const char *text, uint8_t length, uint8_t index, const char **argument);

/** Reads a whole number. @return true if the text is a whole number that fits */
bool javino_number(const char *text, uint8_t length, int32_t *number);

#ifdef __cplusplus
}
#endif

#endif
