#include "javino_items.h"

#ifndef JAVINO_VERSION_1_ONLY

#include <string.h>

#define END_OF_NUMBER 0xF

/* Returns the value of a digit. Returns more than 9 for any other character. */
static uint8_t value_of(char c)
{
    return (uint8_t)c ^ '0';
}

/* Returns the id of a text's shape. A new shape gets a new id. Returns JAVINO_ITEM_TEXT if no id is left. */
static uint8_t id_of(javino_board *b, const char *text, uint8_t length)
{
    uint16_t crc = JAVINO_CRC_START(0);
    uint16_t sum = 0;
    char before = 0;
    javino_shape *shape = b->shapes;
    uint8_t id;
    for (; length; length--) {
        char c = *text++;
        if (value_of(c) <= 9) {
            if (before == '0')
                continue;
            c = '0'; /* in shapes, one 0 replaces each number */
        }
        before = c;
        crc = javino_crc16(crc, (uint8_t)c);
        sum += crc;
    }
    for (id = 0; id < b->link.shapes; id++, shape++)
        if (shape->crc == crc && shape->sum == sum)
            return id;
    if (id == JAVINO_SHAPES)
        return JAVINO_ITEM_TEXT;
    b->link.shapes++;
    shape->crc = crc;
    shape->sum = sum;
    return id;
}

void javino_items_code(javino_board *board)
{
    javino_board *b = board;
    uint8_t *out = (uint8_t *)b->text + b->coded;
    const uint8_t *in = out;
    const uint8_t *end = (uint8_t *)b->text + b->whole;
    uint8_t *row = NULL; /* the row of digits that the next percept can extend */
    bool half = false;   /* whether the row's last byte has room for a digit */
    javino_room rest = b->length - b->whole;
    while (in < end) {
        uint8_t length = in[1];
        uint8_t id = in[0];
        in += JAVINO_ITEM_HEADER;
        if (JAVINO_IS_2(&b->link)) {
            if (id == JAVINO_ITEM_NEW)
                id = id_of(b, (const char *)in, length);
            if (id < b->link.known) {
                bool number = false;
                if (!row || (uint8_t)(row[0] + row[1]) != (uint8_t)(JAVINO_ITEM_DIGITS + id)) {
                    row = out;
                    *out++ = JAVINO_ITEM_DIGITS + id;
                    *out++ = 0;
                    half = false;
                }
                row[1]++;
                for (; length; length--) {
                    uint8_t digit = value_of((char)*in++);
                    if (digit <= 9) {
                        number = true;
                    } else if (number) {
                        number = false;
                        digit = END_OF_NUMBER;
                    } else {
                        continue;
                    }
                    if (half)
                        out[-1] &= 0xF0 | digit;
                    else
                        *out++ = (uint8_t)(digit << 4) | END_OF_NUMBER;
                    half = !half;
                }
                continue;
            }
            row = NULL;
            *out++ = id;
            *out++ = length;
        }
        memmove(out, in, length);
        out += length;
        in += length;
    }
    memmove(out, end, rest);
    b->whole = b->coded = (javino_room)(out - (uint8_t *)b->text);
    b->length = b->whole + rest;
}

#endif
