/**
 * @file Critical rules, which the board itself watches. A rule has conditions on percepts, and may have a reflex: a command. The board
 *     carries the reflex out when the conditions begin to match. The computer sets rules with special commands, which javino_board_poll
 *     handles. See "Rules on the board" in docs/protocol.md.
 */
#ifndef JAVINO_RULES_H
#define JAVINO_RULES_H

#include "javino_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The most rules of a board. Their texts must also fit. */
#define JAVINO_RULES_MAX 8

/** The most bytes of an answer in one part while rules are set. A critical report waits for at most one such part. */
#define JAVINO_SHORT_PART 12

/** Milliseconds between two checks of the sensors. */
#define JAVINO_RULES_MS 5

/** Writes the wanted percepts without sending them. */
typedef void (*javino_perceive)(void *context);

/** Carries out the command of a reflex. @return false if the command is unknown or malformed */
typedef bool (*javino_act)(void *context, const char *text, uint8_t length);

/** The rules of a board, in the board's memory. The members are private. */
struct javino_rules {
    javino_act act;
    javino_perceive perceive; /* NULL until the program's first look */
    bool (*is_free)(void *context);
    uint8_t *texts; /* for each rule its length, then number, functor, conditions and reflex */
    uint16_t looked_ms;
    uint16_t size; /* size of texts in bytes */
    uint16_t used;
    uint8_t met;  /* rules that matched at the last look, one bit each, the first rule lowest */
    uint8_t seen; /* rules that have matched so far in this look */
    uint8_t session; /* session of the answer that goes out in parts */
};

/**
 * Takes memory for rules. Call this before the first byte arrives. While a rule is set, answers go out in parts of JAVINO_SHORT_PART
 * bytes, one part in each javino_board_poll.
 *
 * @param size     size of the memory in bytes, at most 255. A rule takes about 20 bytes
 * @param act      carries a reflex out. Gets the board's context, like write
 * @param is_free  returns true if all earlier bytes have left, so the next part may follow. NULL: parts never wait
 * @return true if there was enough memory and nothing had arrived
 */
bool javino_rules_init(javino_board *board, uint8_t size, javino_act act, bool (*is_free)(void *context));

/**
 * If JAVINO_RULES_MS have passed since the last look, gets the percepts of the rules. When a rule begins to match, carries out its reflex
 * and reports it to the computer. Call this in each run of the main loop, after javino_board_poll.
 */
void javino_rules_look(javino_board *board, javino_perceive perceive, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
