/**
 * @file Reads the text of an action: a literal in the agent's words, such as ledOn, speed(120) or say("hi; you"). Texts are not terminated;
 * nothing is copied.
 */
#ifndef JAVINO_LITERAL_H
#define JAVINO_LITERAL_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The place of a reader in a text: the depth of brackets, and the open quotes. All zero at first. */
typedef struct {
    uint8_t depth;
    char quote; /**< 0 outside of quotes. */
    bool escaped;
    bool crossed;   /**< A bracket was closed by one of another kind, or was not open. */
    uint32_t kinds; /**< The innermost sixteen open brackets, two bits each. */
} javino_nesting;

/** Takes one character. @return true if it stands outside of brackets and quotes, and is neither */
bool javino_outside(javino_nesting *nesting, char c);

/** @return the number of bytes in front of the first bracket, at most length; a zero also ends the text */
uint8_t javino_word(const char *text, uint8_t length);

/**
 * @return the length of the literal's functor; 0: the text is no literal. Brackets or quotes are open or cross each other, an argument is
 *     missing, or something other than annotations follows the arguments.
 */
uint8_t javino_functor(const char *text, uint8_t length);

/**
 * Finds the argument of a literal with this index, from 0. Sets `argument` to its first byte, behind spaces. @return its length; 0: none
 */
uint8_t javino_argument(const char *text, uint8_t length, uint8_t index, const char **argument);

/** Reads a whole number. @return true: the text is a whole number that fits */
bool javino_number(const char *text, uint8_t length, int32_t *number);

#ifdef __cplusplus
}
#endif

#endif
