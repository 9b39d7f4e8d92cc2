#include "javino_items.h"

#ifndef JAVINO_VERSION_1_ONLY

#define END_OF_NUMBER 0xF

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* Of a text without its digits: a CRC and, in the upper half, the sum of the CRCs of all its beginnings. */
static uint32_t checksum(const char *text, uint8_t length)
{
    uint16_t crc = JAVINO_CRC_START;
    uint16_t sum = 0;
    bool number = false;
    for (; length; length--) {
        char c = *text++;
        bool within = number;
        number = is_digit(c);
        if (number && within)
            continue;
        if (number)
            c = '0'; /* stands for any number */
        crc = javino_crc16(crc, (uint8_t)c);
        sum += crc;
    }
    return (uint32_t)sum << 16 | crc;
}

/* The id of a text's shape, which is a new one if need be; JAVINO_ITEM_TEXT if there is no room for it. */
static uint8_t id_of(javino_board *b, const char *text, uint8_t length)
{
    uint32_t shape = checksum(text, length);
    uint8_t id;
    for (id = 0; id < b->link.shapes; id++)
        if (b->shapes[id] == shape)
            return id;
    if (id == JAVINO_SHAPES)
        return JAVINO_ITEM_TEXT;
    b->shapes[id] = shape;
    b->link.shapes++;
    return id;
}

static void put_half(javino_board *b, uint8_t value)
{
    uint8_t *end = (uint8_t *)b->text + b->length;
    b->half = !b->half;
    if (b->half) {
        *end = (uint8_t)(value << 4) | END_OF_NUMBER;
        b->length++;
    } else {
        end[-1] = (end[-1] & 0xF0) | value;
    }
}

/* Writes the digits of a text over itself, into the row in front of it if that goes on with this id. */
static void put_digits(javino_board *b, uint8_t id, const char *text, uint8_t length)
{
    uint8_t *p = (uint8_t *)b->text;
    bool number = false;
    uint8_t head = JAVINO_ITEM_DIGITS + id;
    b->length = b->whole;
    if (!b->row || (uint8_t)(p[b->row - 1] + p[b->row]) != head) {
        p[b->length] = head;
        p[b->length + 1] = 0;
        b->length += JAVINO_ITEM_HEADER;
        b->row = b->length - 1;
        b->half = false;
    }
    p[b->row]++;
    for (; length; length--) {
        char c = *text++;
        if (is_digit(c))
            put_half(b, c & 0x0F);
        else if (number)
            put_half(b, END_OF_NUMBER);
        number = is_digit(c);
    }
}

void javino_item_end(javino_board *board)
{
    javino_board *b = board;
    char *item = b->text + b->whole;
    char *text = item + JAVINO_ITEM_HEADER;
    uint8_t length = (uint8_t)(b->length - b->whole - JAVINO_ITEM_HEADER);
#if JAVINO_TEXT_MAX > 255
    uint8_t id = b->split ? JAVINO_ITEM_TEXT : id_of(b, text, length);
#else
    uint8_t id = id_of(b, text, length);
#endif
    if (id < b->link.known) {
        put_digits(b, id, text, length);
        return;
    }
    item[0] = (char)id;
    item[1] = (char)length;
    b->row = 0;
}

#endif
