/**
 * @file
 * Critical rules that a board watches by itself: conditions on percepts, and a command that the board carries out as a reflex
 * when they begin to be met. The computer sets them with commands of their own, which javino_board_poll handles; see "Rules on the board"
 * in docs/protocol.md.
 */
#ifndef JAVINO_RULES_H
#define JAVINO_RULES_H

#include "javino_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The largest number of rules on a board, as far as their texts find room. */
#define JAVINO_RULES_MAX 8

/** Bytes of an answer in a part while rules are set, so that a critical report waits only for little. */
#define JAVINO_SHORT_PART 12

/** Milliseconds between two looks at the sensors. */
#define JAVINO_RULES_MS 5

/** Writes the percepts that are wanted, as for a request, but does not answer. */
typedef void (*javino_perceive)(void *context);

/** Carries out the command of a reflex. @return false if it is unknown or malformed */
typedef bool (*javino_act)(void *context, const char *text, uint8_t length);

/** The rules of a board. They lie in its memory; the members are private. */
struct javino_rules {
    javino_act act;
    javino_perceive perceive; /* NULL until the program has looked */
    bool (*is_free)(void *context);
    uint8_t *texts; /* each behind its length: the rule's number, functor and so on */
    uint16_t looked_ms;
    uint16_t size; /* bytes that texts has room for */
    uint16_t used;
    uint8_t met;  /* rules that were met at the last look, the first in the lowest bit */
    uint8_t seen; /* rules that are met at this look */
    uint8_t session; /* session of the answer that goes out part by part */
};

/**
 * Takes memory for rules, before the first byte arrives. From now on answers go out in parts of JAVINO_SHORT_PART bytes while a rule is
 * set, a part with each javino_board_poll.
 *
 * @param size     bytes, at most 255; a rule takes about 20
 * @param act      handed the board's context, as write is
 * @param is_free  returns true if all earlier bytes have left, so that the next part may follow; NULL: it always may
 * @return true if there is so much memory, and nothing has arrived
 */
bool javino_rules_init(javino_board *board, uint8_t size, javino_act act, bool (*is_free)(void *context));

/**
 * Looks at the sensors that the rules name, if JAVINO_RULES_MS have passed. When a rule begins to be met, carries out its reflex and
 * reports it to the computer. Call it in each turn of the main loop, after javino_board_poll.
 */
void javino_rules_look(javino_board *board, javino_perceive perceive, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
