#include "javino_board.h"

#include <string.h>

#include "javino_items.h"
#include "javino_literal.h"

#ifdef JAVINO_VERSION_1_ONLY
#define IS_PLAIN(board) true
#define IS_OPEN(board) false
#else
/* Text for a request of version 1 stands as it is, any other in items. */
#define IS_PLAIN(board) ((board)->link.event == JAVINO_REQUEST && (board)->link.version == 1)
/* Whether parts of an answer have gone out, but not the last. */
#define IS_OPEN(board) ((board)->part != 0)
/* Bytes of an answer in a frame; in version 2 besides the numbers of the request and the part. */
#define PART_MAX (JAVINO_MAX_PAYLOAD - 2)
#if JAVINO_TEXT_MAX > 255
#define SPLITS /* percepts that are longer than the memory into pieces */
#endif
#endif

#ifndef JAVINO_VERSION_1_ONLY
static JAVINO_NOINLINE bool rule(javino_board *b, uint8_t where)
{
    return b->rule && b->rule(b, where);
}
#endif

/* Bytes of an answer that a frame holds. */
static uint8_t frame_max(const javino_board *b)
{
#ifndef JAVINO_VERSION_1_ONLY
    if (b->link.version == 2)
        return PART_MAX;
#endif
    (void)b;
    return JAVINO_MAX_PAYLOAD;
}

bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context)
{
    memset(board, 0, offsetof(javino_board, link));
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
    const char *p = board->link.text;
    const char *end;
    bool all = true;
#ifndef JAVINO_VERSION_1_ONLY
    if (board->link.event == JAVINO_WATCH)
        return board->watches(board, functor, length);
#endif
    if (board->link.event != JAVINO_REQUEST)
        return true;
    end = p + board->link.length;
    /* Each name stands between a bracket or comma and another. */
    for (; p < end; p++) {
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
#ifndef JAVINO_VERSION_1_ONLY
    board->row = 0;
    board->answering = 0;
#endif
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
    if (room > JAVINO_MAX_PAYLOAD && (JAVINO_TEXT_MAX == 255 || b->link.event == JAVINO_REQUEST || b->link.version == 1))
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

/* ---- Sending ---- */

#ifndef JAVINO_VERSION_1_ONLY

/* Begins the frame of a part of an answer, of so many bytes of it. */
static void begin_part(javino_board *b, bool last, uint8_t length)
{
    javino_link *l = &b->link;
    uint8_t part = b->part++;
    uint8_t kind = last ? JAVINO_PERCEPTS_LAST : JAVINO_PERCEPTS_PART;
    uint8_t size = length + 2;
    uint8_t request = l->request;
    if (last) {
        b->part = 0;
        l->answered = true;
        l->request = 0;
        if (!part) {
            kind = JAVINO_PERCEPTS;
            size--;
        }
    }
    javino_link_begin(l, kind, size);
    javino_encoder_put(&l->encoder, request);
    if (kind != JAVINO_PERCEPTS)
        javino_encoder_put(&l->encoder, part);
}

/* Sends an item that is a part of its own. */
static void send_item(javino_board *b, bool last, uint8_t head, const char *text, uint8_t length)
{
    javino_encoder *e = &b->link.encoder;
    begin_part(b, last, length + JAVINO_ITEM_HEADER);
    javino_encoder_put(e, head);
    javino_encoder_put(e, length);
    javino_encoder_finish(e, text, length);
}

static void begin_item(javino_board *b)
{
    b->text[b->length] = JAVINO_ITEM_CONTINUED;
    b->length += JAVINO_ITEM_HEADER;
}

#endif

JAVINO_OUTLINE void javino_board_send_text(javino_board *board, bool last, javino_room n)
{
    javino_board *b = board;
#ifdef JAVINO_VERSION_1_ONLY
    (void)last;
    javino_link_send(&b->link, b->text, (uint8_t)n);
#else
    b->row = 0;
    if (b->link.version == 1) {
        javino_link_send(&b->link, b->text, (uint8_t)n);
    } else {
        begin_part(b, last, (uint8_t)n);
        javino_encoder_finish(&b->link.encoder, b->text, (uint8_t)n);
    }
#endif
    b->length -= n;
    b->whole -= n;
    if (b->length)
        memmove(b->text, b->text + n, b->length);
}

/* Sends as much as one frame holds ahead of the rest: in version 1 whole percepts. */
static JAVINO_OUTLINE bool send_ahead(javino_board *b)
{
    javino_room n = b->whole;
#ifdef SPLITS
    bool splits = !n && !IS_PLAIN(b);
    if (splits) {
        b->split = true;
        b->text[1] = (char)(b->length - JAVINO_ITEM_HEADER);
        n = b->whole = b->length;
    }
#endif
    if (n == 0)
        return false;
    if (n > frame_max(b))
        n = frame_max(b);
    javino_board_send_text(b, false, n);
#ifdef SPLITS
    if (splits)
        begin_item(b);
#endif
    return true;
}

/* ---- Percepts ---- */

bool javino_percept_begin(javino_board *board, const char *functor)
{
    const char *name = *functor == '~' ? functor + 1 : functor; /* A negation is not part of it. */
    if (!javino_board_wants(board, name, strlen(name)))
        return false;
    javino_percept_text(board, functor);
    return true;
}

/* Whether there is room for so many bytes more. */
static JAVINO_OUTLINE bool has_room(javino_board *b, uint8_t bytes)
{
    if (b->room - b->length < bytes)
        place_text(b);
    if (b->room - b->length < bytes && (b->link.event != JAVINO_REQUEST || !send_ahead(b)))
        b->overlong = true;
    return !b->overlong;
}

JAVINO_OUTLINE void javino_percept_put(javino_board *board, char c)
{
    javino_board *b = board;
#ifndef JAVINO_VERSION_1_ONLY
    if (b->length == b->whole && !IS_PLAIN(b) && has_room(b, JAVINO_ITEM_HEADER))
        begin_item(b);
#endif
    if (has_room(b, 1))
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

#ifndef JAVINO_VERSION_1_ONLY

/* Ends the item that is being written. What nobody has asked for is coded when it is sent: a session may begin until then. */
static JAVINO_OUTLINE void end_item(javino_board *b)
{
    javino_room length = b->length - b->whole - JAVINO_ITEM_HEADER;
    if (b->overlong || IS_PLAIN(b))
        return;
    if (b->link.event == JAVINO_REQUEST) {
        javino_item_end(b);
        return;
    }
#if JAVINO_TEXT_MAX > 255
    b->overlong = length > JAVINO_MAX_PAYLOAD;
#endif
    b->text[b->whole] = JAVINO_ITEM_TEXT;
    b->text[b->whole + 1] = (char)length;
}

/* Makes of the percepts that have waited what the version is that they are sent in. */
static JAVINO_OUTLINE void code_waiting(javino_board *b)
{
    char *from = b->text;
    char *end;
    b->length = b->whole;
    if (!b->length)
        return;
    end = from + b->whole;
    b->whole = 0;
    while (from < end) {
        uint8_t n = (uint8_t)from[1];
        bool plain = b->link.version == 1;
        if (plain)
            from += JAVINO_ITEM_HEADER;
        else
            n += JAVINO_ITEM_HEADER;
        memmove(b->text + b->whole, from, n);
        from += n;
        b->length = b->whole + n;
        if (!plain)
            javino_item_end(b);
        b->whole = b->length;
    }
}

#endif

bool javino_percept_end(javino_board *board)
{
    bool fits;
    javino_percept_put(board, ';');
#ifndef JAVINO_VERSION_1_ONLY
    end_item(board);
    if (board->link.event == JAVINO_WATCH) {
        if (!board->overlong)
            rule(board, JAVINO_RULES_PERCEPT);
        board->length = board->whole;
    }
#endif
    fits = !board->overlong;
    if (!fits)
        board->length = board->whole;
#ifdef SPLITS
    board->split = false;
#endif
    board->overlong = false;
    board->whole = board->length;
    return fits;
}

/* ---- Answers ---- */

JAVINO_OUTLINE void javino_board_answer(javino_board *board)
{
    javino_board *b = board;
#ifndef JAVINO_VERSION_1_ONLY
    b->length = b->whole;
    if (rule(b, JAVINO_RULES_ANSWER))
        return;
    if (b->link.event != JAVINO_REQUEST)
        code_waiting(b);
#endif
    while (b->length > frame_max(b))
        send_ahead(b);
    if (b->length || IS_OPEN(b) || !b->link.answered)
        javino_board_send_text(b, true, b->length);
    javino_board_clear(b);
}

javino_event javino_board_poll(javino_board *board, uint16_t now_ms)
{
    javino_board *b = board;
#ifndef JAVINO_VERSION_1_ONLY
    if (!rule(b, JAVINO_RULES_GO_ON))
#endif
    {
        if (IS_OPEN(b))
            javino_board_answer(b);
        if (b->link.event == JAVINO_REQUEST)
            javino_board_clear(b);
    }
    javino_link_poll(&b->link, now_ms);
#ifndef JAVINO_VERSION_1_ONLY
    if (b->link.event == JAVINO_REQUEST) {
        rule(b, JAVINO_RULES_ALL);
        code_waiting(b);
    }
#endif
#if JAVINO_TEXT_MAX > 255
    /* What has waited for version 2 may be too long for version 1. */
    if (b->link.version == 1 && b->room > JAVINO_MAX_PAYLOAD)
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
                javino_link_send(link, text + sent, (uint8_t)(whole - sent));
            sent = whole;
            if (end - sent > JAVINO_MAX_PAYLOAD) {
                complete = false;
                sent = end;
            }
        }
        whole = end;
    }
    if (length > sent)
        javino_link_send(link, text + sent, (uint8_t)(length - sent));
    return complete;
}

bool javino_board_send(javino_board *board, const char *text, size_t length)
{
    javino_link *link = &board->link;
#ifndef JAVINO_VERSION_1_ONLY
    const uint8_t most = PART_MAX - JAVINO_ITEM_HEADER;
    rule(board, JAVINO_RULES_ALL);
    if (link->version == 2) {
        for (; length > most; length -= most, text += most)
            send_item(board, false, JAVINO_ITEM_CONTINUED, text, most);
        if (length) {
            send_item(board, true, JAVINO_ITEM_TEXT, text, (uint8_t)length);
        } else {
            begin_part(board, true, 0);
            javino_encoder_end(&link->encoder);
        }
        return true;
    }
#endif
    if (length > JAVINO_MAX_PAYLOAD)
        return send_in_parts(link, text, length);
    javino_link_send(link, text, (uint8_t)length);
    return true;
}
