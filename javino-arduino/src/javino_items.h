/**
 * @file
 * Codes the percepts of an answer in place, for javino_board.c.
 */
#ifndef JAVINO_ITEMS_H
#define JAVINO_ITEMS_H

#include "javino_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The first bytes of items. Any smaller first byte is the id of a text. */
enum {
    JAVINO_ITEM_CONTINUED = 0x7E, /**< The beginning of a text that continues in the next item. */
    JAVINO_ITEM_TEXT = 0x7F,      /**< A text without an id. */
    JAVINO_ITEM_DIGITS = 0x80,    /**< Plus an id: only digits follow, for the percept with this id and those with the next ids. */
    JAVINO_ITEM_NEW = 0xFF        /**< Never sent: a text that is not coded yet. */
};

/** Number of bytes before an item's text. */
#define JAVINO_ITEM_HEADER 2

/** Codes the percepts that are not coded yet, in the answer's version. An unfinished percept stays after the coded percepts. */
void javino_items_code(javino_board *board);

#ifdef __cplusplus
}
#endif

#endif
