/**
 * @file Critical rules, which the board itself watches. A rule has conditions on percepts, and may have a reflex: a command that the board
 * carries out when the conditions begin to be met. The computer sets rules by special commands, which javino_board_poll handles; see "Rules
 * on the board" in docs/protocol.md.
 */
#ifndef JAVINO_RULES_H
#define JAVINO_RULES_H

#include "javino_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most rules of a board, if there is room for their texts. */
#define JAVINO_RULES_MAX 8

/** While rules are set, each part of an answer has at most this many bytes: so a critical report waits at most for one such part. */
#define JAVINO_SHORT_PART 12

/** Milliseconds between two looks at the sensors. */
#define JAVINO_RULES_MS 5

/** Writes the wanted percepts, as for a request, but does not send them. */
typedef void (*javino_perceive)(void *context);

/** Carries out the command of a reflex. @return false: the command is unknown or malformed */
typedef bool (*javino_act)(void *context, const char *text, uint8_t length);

/** The rules of a board, which are kept in the board's memory. The members are private. */
struct javino_rules {
    javino_act act;
    javino_perceive perceive; /* NULL until the program's first look */
    bool (*is_free)(void *context);
    uint8_t *texts; /* for each rule its length, then number, functor and so on */
    uint16_t looked_ms;
    uint16_t size; /* bytes for texts */
    uint16_t used;
    uint8_t met;  /* rules that were met at the last look, a bit each; the first rule is the lowest bit */
    uint8_t seen; /* rules that have been met so far in this look */
    uint8_t session; /* session of the answer that is being sent in parts */
};

/**
 * Takes memory for rules. Call this before the first byte arrives. While a rule is set, answers go out in parts of JAVINO_SHORT_PART bytes,
 * one part in each javino_board_poll.
 *
 * @param size     number of bytes, at most 255; a rule takes about 20
 * @param act      carries a reflex out; gets the board's context, like write
 * @param is_free  returns true if all earlier bytes have left, so that the next part may follow; NULL: parts never wait
 * @return true: there was enough memory, and nothing had arrived
 */
bool javino_rules_init(javino_board *board, uint8_t size, javino_act act, bool (*is_free)(void *context));

/**
 * If JAVINO_RULES_MS have passed since the last look, looks at the sensors of the percepts that the rules name. When a rule begins to be
 * met, carries out its reflex and reports it to the computer. Call it in each round of the main loop, after javino_board_poll.
 */
void javino_rules_look(javino_board *board, javino_perceive perceive, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
