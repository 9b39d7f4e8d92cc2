/**
 * @file
 * Reading the text of an action: a literal such as ledOn, speed(120) or say("hi; you"), as the agent wrote it.
 * Texts are not terminated; nothing is copied.
 */
#ifndef JAVINO_LITERAL_H
#define JAVINO_LITERAL_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The place of a reader in a text: the depth of brackets, and the open quotes. Begins as all zero. */
typedef struct {
    uint8_t depth;
    char quote; /**< 0 outside quotes. */
    bool escaped;
    bool crossed;   /**< A bracket has been closed by one of another kind, or was not open. */
    uint32_t kinds; /**< The innermost sixteen brackets that are open, two bits each. */
} javino_nesting;

/** Takes one character. @return true if it stands outside brackets and quotes, and is neither. */
bool javino_outside(javino_nesting *nesting, char c);

/** @return the bytes before the first bracket, at most length; the text may end before that with a zero. */
uint8_t javino_word(const char *text, uint8_t length);

/**
 * @return the bytes of the literal's functor; 0 if the text is not a literal: brackets or quotes are open or
 *         cross each other, an argument is missing, or something other than annotations follows the arguments.
 */
uint8_t javino_functor(const char *text, uint8_t length);

/**
 * Finds one argument of a literal.
 *
 * @param index     counted from 0
 * @param argument  set to its first byte; spaces around an argument do not belong to it
 * @return its bytes; 0 if there is no such argument
 */
uint8_t javino_argument(const char *text, uint8_t length, uint8_t index, const char **argument);

/**
 * Reads a whole number.
 *
 * @return true if the text is one and fits
 */
bool javino_number(const char *text, uint8_t length, int32_t *number);

#ifdef __cplusplus
}
#endif

#endif
