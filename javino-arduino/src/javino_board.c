#include "javino_board.h"

#include <string.h>

#include "javino_literal.h"

bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context)
{
    memset(board, 0, sizeof *board);
    board->memory = size;
    javino_link_init(&board->link, memory, size - JAVINO_TEXT_MIN, write, context);
    return size >= JAVINO_MEMORY_MIN;
}

void *javino_board_take(javino_board *board, uint16_t size)
{
    javino_decoder *d = &board->link.decoder;
    uint16_t used = d->end + (JAVINO_MEMORY_MIN - JAVINO_TEXT_MIN);
    if (board->room || d->size < used || size > d->size - used)
        return NULL;
    d->size -= size;
    board->memory -= size;
    return d->bytes + board->memory;
}

JAVINO_OUTLINE bool javino_board_wants(const javino_board *board, const char *functor, size_t length)
{
    const javino_frame *request = &board->link.frame;
    const char *p = (const char *)request->payload;
    const char *end = p + request->length;
    bool all = true;
    if (board->link.event != JAVINO_REQUEST)
        return true;
    /* Each name stands between a bracket or comma and another. */
    for (p += JAVINO_REQUEST_LENGTH; p < end; p++) {
        const char *after = p + 1 + length;
        if (*p != '(' && *p != ',')
            continue;
        if (after < end && (*after == ',' || *after == ')') && memcmp(p + 1, functor, length) == 0)
            return true;
        all = false;
    }
    return all;
}

JAVINO_OUTLINE void javino_board_clear(javino_board *board)
{
    board->room = board->length = board->whole = 0;
    board->overlong = false;
    board->link.decoder.size = board->memory - JAVINO_TEXT_MIN;
}

/* Lays the text where it has more room, if there is such a place, and keeps bytes received out of it. Besides a request
 * that is behind the bytes received. Otherwise the longest frame has to find room. */
static JAVINO_OUTLINE void place_text(javino_board *b)
{
    javino_decoder *d = &b->link.decoder;
    char *place = (char *)d->bytes;
    uint16_t base = b->memory - JAVINO_TEXT_MIN;
    uint16_t room;
    if (base > JAVINO_WINDOW)
        base = JAVINO_WINDOW;
    if (b->link.event == JAVINO_REQUEST || base < d->end)
        base = d->end;
    room = b->memory - base;
    /* In version 1 a message is one frame; while an answer is written, bytes arrive. */
    if (room > JAVINO_MAX_PAYLOAD && (JAVINO_TEXT_MAX == 255 || b->link.event == JAVINO_REQUEST || b->link.frame.version != 2))
        room = JAVINO_MAX_PAYLOAD;
    if (room <= b->room)
        return;
    base = b->memory - room;
    b->room = (javino_room)room;
    d->size = base;
    place += base;
    if (b->length)
        memmove(place, b->text, b->length);
    b->text = place;
}

/* Sends as much as one frame holds ahead of the rest: in version 1 whole percepts. */
static JAVINO_OUTLINE bool send_ahead(javino_board *b)
{
    javino_room n = b->whole;
    b->open = b->link.frame.version == 2;
    if (b->open)
        n = b->length;
#if JAVINO_TEXT_MAX > 255
    if (n > JAVINO_MAX_PAYLOAD)
        n = JAVINO_MAX_PAYLOAD;
#endif
    if (n == 0)
        return false;
    javino_link_send(&b->link, b->open ? JAVINO_MORE : 0, b->text, (uint8_t)n);
    b->length -= n;
    b->whole = 0;
    memmove(b->text, b->text + n, b->length);
    return true;
}

bool javino_percept_begin(javino_board *board, const char *functor)
{
    const char *name = *functor == '~' ? functor + 1 : functor; /* A negation is not part of it. */
    if (!javino_board_wants(board, name, strlen(name)))
        return false;
    javino_percept_text(board, functor);
    return true;
}

JAVINO_OUTLINE void javino_percept_put(javino_board *board, char c)
{
    javino_board *b = board;
    if (b->length == b->room)
        place_text(b);
    if (b->length == b->room && (b->link.event != JAVINO_REQUEST || !send_ahead(b)))
        b->overlong = true;
    if (!b->overlong)
        b->text[b->length++] = c;
}

void javino_percept_text(javino_board *board, const char *text)
{
    while (*text)
        javino_percept_put(board, *text++);
}

void javino_percept_number(javino_board *board, uint32_t magnitude, bool negative)
{
    char digits[10];
    uint8_t n = 0;
    if (negative)
        javino_percept_put(board, '-');
    do {
        digits[n++] = (char)('0' + magnitude % 10);
        magnitude /= 10;
    } while (magnitude);
    while (n)
        javino_percept_put(board, digits[--n]);
}

static bool is_atom(const char *text)
{
    char c = *text;
    if (c < 'a' || c > 'z')
        return false;
    while ((c = *++text) != 0)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'))
            return false;
    return true;
}

void javino_percept_term(javino_board *board, const char *text)
{
    if (is_atom(text)) {
        javino_percept_text(board, text);
        return;
    }
    javino_percept_put(board, '"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            javino_percept_put(board, '\\');
        javino_percept_put(board, *text);
    }
    javino_percept_put(board, '"');
}

bool javino_percept_end(javino_board *board)
{
    bool fits;
    javino_percept_put(board, ';');
    fits = !board->overlong;
    if (!fits)
        board->length = board->whole;
    board->overlong = false;
    board->whole = board->length;
    return fits;
}

void javino_board_answer(javino_board *board)
{
    javino_board *b = board;
#if JAVINO_TEXT_MAX > 255
    while (b->length > JAVINO_MAX_PAYLOAD)
        send_ahead(b);
#endif
    if (b->length || b->open || !b->link.answered)
        javino_link_send(&b->link, 0, b->text, (uint8_t)b->length);
    b->open = false;
    javino_board_clear(b);
}

javino_event javino_board_poll(javino_board *board, uint16_t now_ms)
{
    javino_board *b = board;
    if (b->open)
        javino_board_answer(b);
    if (b->link.event == JAVINO_REQUEST)
        javino_board_clear(b);
    javino_link_poll(&b->link, now_ms);
#if JAVINO_TEXT_MAX > 255
    /* What has waited for version 2 may be too long for version 1. */
    if (b->link.frame.version != 2 && b->room > JAVINO_MAX_PAYLOAD)
        javino_board_clear(b);
#endif
    return b->link.event;
}

/* In parts of whole percepts. */
static bool send_in_parts(javino_link *link, const char *text, size_t length)
{
    javino_nesting n = {0, 0, false, false, 0};
    size_t sent = 0;  /* up to here it has been sent or left out */
    size_t whole = 0; /* up to here there are whole percepts */
    size_t end;
    bool complete = true;
    for (end = 1; end <= length; end++) {
        bool outside = javino_outside(&n, text[end - 1]);
        if (!(outside && text[end - 1] == ';') && end < length)
            continue;
        if (end - sent > JAVINO_MAX_PAYLOAD) {
            if (whole > sent)
                javino_link_send(link, 0, text + sent, (uint8_t)(whole - sent));
            sent = whole;
            if (end - sent > JAVINO_MAX_PAYLOAD) {
                complete = false;
                sent = end;
            }
        }
        whole = end;
    }
    if (length > sent)
        javino_link_send(link, 0, text + sent, (uint8_t)(length - sent));
    return complete;
}

bool javino_board_send(javino_board *board, const char *text, size_t length)
{
    javino_link *link = &board->link;
    if (link->frame.version != 2 && length > JAVINO_MAX_PAYLOAD)
        return send_in_parts(link, text, length);
    for (; length > JAVINO_MAX_PAYLOAD; length -= JAVINO_MAX_PAYLOAD, text += JAVINO_MAX_PAYLOAD)
        javino_link_send(link, JAVINO_MORE, text, JAVINO_MAX_PAYLOAD);
    javino_link_send(link, 0, text, (uint8_t)length);
    return true;
}
