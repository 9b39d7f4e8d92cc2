#include "javino_board.h"

#include <string.h>

#include "javino_items.h"
#include "javino_literal.h"
#include "javino_rules.h"

#ifdef JAVINO_VERSION_1_ONLY
#define IS_OPEN(board) false
#define HEADER 0
#else
/* True if a part of an answer has gone out, but not its last part. */
#define IS_OPEN(board) ((board)->part != 0)
#define HEADER JAVINO_ITEM_HEADER
/* The most bytes of an answer in one frame. The frame also has the numbers of the request and the part. */
#define PART_MAX (JAVINO_MAX_PAYLOAD - 2)
#if JAVINO_TEXT_MAX > 255
#define SPLITS /* a percept that is longer than the memory goes out in pieces */
#endif
#endif

#define NOT_SAME 0xFF /* this name differs from the functor */

#ifndef JAVINO_VERSION_1_ONLY
static JAVINO_NOINLINE bool rule(javino_board *b, uint8_t where)
{
    return b->rule && b->rule(b, where);
}
#endif

static uint16_t least(uint16_t a, uint16_t b)
{
    return a < b ? a : b;
}

JAVINO_OUTLINE void javino_board_place(javino_board *board, uint16_t base)
{
    javino_board *b = board;
    javino_decoder *d = &b->link.decoder;
    uint8_t *place = d->bytes;
    uint16_t room = b->memory - base;
    /* In version 1 a message is one frame. Bytes that arrive while the program writes an answer also need room. */
#if JAVINO_TEXT_MAX > 255
    if (!JAVINO_IS_2(&b->link))
        room = least(room, JAVINO_MAX_PAYLOAD + HEADER);
    else if (b->link.event == JAVINO_REQUEST)
        room = least(room, PART_MAX);
    if (room < b->length)
        return;
#elif defined JAVINO_VERSION_1_ONLY
    room = least(room, JAVINO_MAX_PAYLOAD);
#else
    room = least(room, b->link.event == JAVINO_REQUEST && !JAVINO_IS_2(&b->link) ? JAVINO_MAX_PAYLOAD : PART_MAX);
#endif
    b->room = (javino_room)room;
    d->size = b->memory - room;
    place += d->size;
    if (b->length)
        memmove(place, b->text, b->length);
    b->text = (char *)place;
}

JAVINO_OUTLINE void javino_board_clear(javino_board *board)
{
    uint16_t base = board->memory - JAVINO_TEXT_MIN;
    board->length = board->whole = 0;
    board->overlong = false;
#ifndef JAVINO_VERSION_1_ONLY
    board->coded = 0;
    board->answering = 0;
#endif
    javino_board_place(board, least(base, JAVINO_WINDOW));
}

bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context)
{
    memset(board, 0, offsetof(javino_board, link));
    board->memory = size;
    javino_link_init(&board->link, memory, 0, write, context);
    if (size < JAVINO_MEMORY_MIN)
        return false;
    javino_board_clear(board);
    return true;
}

JAVINO_NOINLINE void *javino_board_take(javino_board *board, uint16_t size)
{
    javino_decoder *d = &board->link.decoder;
    uint16_t left = board->memory - d->end;
    if (board->length || left < JAVINO_MEMORY_MIN + (uint32_t)size)
        return NULL;
    board->memory -= size;
    javino_board_clear(board);
    return d->bytes + board->memory;
}

void *javino_board_take_front(javino_board *board, uint16_t size)
{
    javino_decoder *d = &board->link.decoder;
    uint8_t *front = d->bytes;
    if (d->end || !javino_board_take(board, size))
        return NULL;
    d->bytes += size;
    javino_board_clear(board);
    return front;
}

#ifndef JAVINO_NO_FUNCTOR_LISTS
/* True if the request lists this functor, or has no list. */
static bool is_named(const javino_link *link, const char *functor, uint8_t length)
{
    const char *p = link->text;
    uint8_t left = link->length;
    uint8_t same = NOT_SAME; /* number of matching bytes at the start of this name */
    bool all = true;
    /* A bracket or a comma precedes and follows each name. */
    for (; left; left--) {
        char c = *p++;
        if (c == '(' || c == ',' || c == ')') {
            if (same == length)
                return true;
            same = 0;
            all = false;
        } else if (same < length && functor[same] == c) {
            same++;
        } else {
            same = NOT_SAME;
        }
    }
    return all;
}
#endif

bool javino_board_wants(const javino_board *board, const char *functor, uint8_t length)
{
#ifndef JAVINO_VERSION_1_ONLY
    if (board->link.event == JAVINO_WATCH)
        return board->watches(board, functor, length);
#endif
#ifdef JAVINO_NO_FUNCTOR_LISTS
    (void)board;
    (void)functor;
    (void)length;
    return true;
#else
    return board->link.event != JAVINO_REQUEST || is_named(&board->link, functor, length);
#endif
}

/* ---- Sending ---- */

#ifndef JAVINO_VERSION_1_ONLY

/*
 * Begins the frame of a part of an answer.
 * length: number of answer bytes in the part
 */
static void begin_part(javino_board *b, bool last, uint8_t length)
{
    javino_link *l = &b->link;
    uint8_t part = b->part++;
    uint8_t kind = last ? JAVINO_PERCEPTS_LAST : JAVINO_PERCEPTS_PART;
    uint8_t size = length + 2;
    uint8_t request = l->request;
    if (last) {
        b->part = 0;
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

/* Sends an item as a separate part. */
static void send_item(javino_board *b, bool last, uint8_t head, const char *text, uint8_t length)
{
    javino_encoder *e = &b->link.encoder;
    begin_part(b, last, length + JAVINO_ITEM_HEADER);
    javino_encoder_put(e, head);
    javino_encoder_put(e, length);
    javino_encoder_finish(e, text, length);
}

#endif

void javino_board_send_text(javino_board *board, bool last, javino_room n)
{
    javino_board *b = board;
#ifdef JAVINO_VERSION_1_ONLY
    javino_encoder_begin(&b->link.encoder, (uint8_t)n);
#elif defined(JAVINO_VERSION_2_ONLY)
    begin_part(b, last, (uint8_t)n);
#else
    if (JAVINO_IS_2(&b->link))
        begin_part(b, last, (uint8_t)n);
    else
        javino_encoder_begin(&b->link.encoder, (uint8_t)n);
#endif
    (void)last;
    b->link.answered = true;
    javino_encoder_finish(&b->link.encoder, b->text, (uint8_t)n);
    b->length -= n;
    b->whole -= n;
    memmove(b->text, b->text + n, b->length);
#ifndef JAVINO_VERSION_1_ONLY
    b->coded = b->whole;
#endif
}

/* Codes the percepts that are not coded yet. An unfinished percept stays after the coded percepts. */
static JAVINO_NOINLINE void code(javino_board *b)
{
#ifdef JAVINO_VERSION_1_ONLY
    (void)b;
#else
    javino_items_code(b);
#endif
}

static void put(javino_board *b, char c);

#ifndef JAVINO_VERSION_1_ONLY
static void begin_item(javino_board *b)
{
    put(b, (char)JAVINO_ITEM_NEW);
    put(b, 0); /* the item's length */
}
#endif

/* Sends as many whole percepts as a frame holds. If a percept is longer than the memory, sends a piece of it. */
static void send_ahead(javino_board *b)
{
    javino_room n = b->whole;
#ifdef SPLITS
    if (n == 0 && JAVINO_IS_2(&b->link)) {
        b->split = true;
        b->text[0] = JAVINO_ITEM_CONTINUED;
        b->text[1] = (char)(b->length - JAVINO_ITEM_HEADER);
        b->whole = b->length;
        javino_board_send_text(b, false, b->whole);
        begin_item(b);
        return;
    }
    if (n > PART_MAX && JAVINO_IS_2(&b->link))
        n = PART_MAX;
#endif
#ifndef JAVINO_VERSION_1_ONLY
    /* If rules are set, sends only one short part, so the rules are checked before the next part. */
    if (n > JAVINO_SHORT_PART && b->link.rules && JAVINO_IS_2(&b->link))
        n = JAVINO_SHORT_PART;
#endif
    if (n)
        javino_board_send_text(b, false, n);
}

/* Makes room for one more byte of an answer. If necessary, sends a part of the answer early. */
static void make_room(javino_board *b)
{
    if (b->link.event == JAVINO_REQUEST) {
        code(b);
        if (b->length == b->room)
            send_ahead(b);
    }
    if (b->length == b->room)
        b->overlong = true;
}

/* ---- Percepts ---- */

bool javino_kind_begin(javino_board *board)
{
    const javino_link *l = &board->link;
    if (l->event != JAVINO_REQUEST || l->length != 3 || l->text[1] != '?')
        return false; /* Only the list (?) asks for kinds. */
    javino_percept_put(board, '?');
#ifndef JAVINO_VERSION_1_ONLY
    board->text[board->whole] = JAVINO_ITEM_TEXT; /* The text must not use up a shape. */
#endif
    return true;
}

bool javino_percept_begin(javino_board *board, const char *functor)
{
    const char *name = *functor == '~' ? functor + 1 : functor; /* Requests name functors without the ~. */
    if (!javino_board_wants(board, name, (uint8_t)strlen(name)))
        return false;
    javino_percept_text(board, functor);
    return true;
}

static void put(javino_board *b, char c)
{
    if (b->length == b->room)
        make_room(b);
    if (!b->overlong)
        b->text[b->length++] = c;
}

JAVINO_NOINLINE void javino_percept_put(javino_board *board, char c)
{
#ifndef JAVINO_VERSION_1_ONLY
    if (board->length == board->whole)
        begin_item(board);
#endif
    put(board, c);
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

void javino_percept_string(javino_board *board, const char *text)
{
    javino_percept_put(board, '"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            javino_percept_put(board, '\\');
        javino_percept_put(board, *text);
    }
    javino_percept_put(board, '"');
}

void javino_percept_term(javino_board *board, const char *text)
{
    if (is_atom(text))
        javino_percept_text(board, text);
    else
        javino_percept_string(board, text);
}

bool javino_percept_end(javino_board *board)
{
    javino_board *b = board;
    javino_room length;
    bool fits;
    javino_percept_put(b, ';');
    length = b->length - b->whole - HEADER;
#ifdef SPLITS
    if (length > JAVINO_MAX_PAYLOAD)
        b->overlong = true;
    if (b->split)
        b->text[b->whole] = JAVINO_ITEM_TEXT;
    b->split = false;
#endif
    fits = !b->overlong;
    b->overlong = false;
    if (fits) {
#ifdef JAVINO_VERSION_1_ONLY
        (void)length;
#else
        b->text[b->whole + 1] = (char)length;
        if (b->link.event == JAVINO_WATCH)
            rule(b, JAVINO_RULES_PERCEPT);
        else
#endif
            b->whole = b->length;
    }
    b->length = b->whole;
    return fits;
}

/* ---- Answers ---- */

void javino_board_answer(javino_board *board)
{
    javino_board *b = board;
#ifdef JAVINO_VERSION_2_ONLY
    if (!b->link.session) {
        javino_board_clear(b);
        b->part = 0;
        return;
    }
#endif
    b->length = b->whole;
    code(b);
#ifndef JAVINO_VERSION_1_ONLY
    if (rule(b, JAVINO_RULES_ANSWER))
        return;
#endif
#if JAVINO_TEXT_MAX > 255
    while (b->length > PART_MAX && JAVINO_IS_2(&b->link))
        javino_board_send_text(b, false, PART_MAX);
#endif
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
        if (b->link.event == JAVINO_REQUEST) {
            b->link.event = JAVINO_NOTHING;
            javino_board_clear(b);
        }
    }
#ifdef JAVINO_VERSION_1_ONLY
    javino_link_poll(&b->link, now_ms);
#else
    while (javino_link_poll(&b->link, now_ms) == JAVINO_RULE)
        rule(b, JAVINO_RULES_SET);
#endif
#ifdef SPLITS
    if (!JAVINO_IS_2(&b->link))
        b->part = 0; /* An answer ends with its session. */
#endif
#if JAVINO_TEXT_MAX > 255
    /* A percept for version 2 may be too long for version 1. */
    if (b->length == 0 || (!JAVINO_IS_2(&b->link) && b->room > JAVINO_MAX_PAYLOAD + HEADER))
        javino_board_clear(b);
#endif
    if (b->link.event == JAVINO_REQUEST) {
        uint16_t base = b->link.decoder.end;
#ifndef JAVINO_VERSION_1_ONLY
        if (rule(b, JAVINO_RULES_END))
            base += JAVINO_TEXT_MIN;
#endif
        b->length = b->whole;
        javino_board_place(b, base);
        code(b);
    }
    return b->link.event;
}

#ifndef JAVINO_VERSION_2_ONLY
/* Sends the text in parts of whole percepts. */
static bool send_in_parts(javino_link *link, const char *text, size_t length)
{
    javino_nesting n = {0, 0, false, false, 0};
    size_t sent = 0;  /* all text before this index is sent or left out */
    size_t whole = 0; /* the percepts before this index are complete */
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
#endif

bool javino_board_send(javino_board *board, const char *text, size_t length)
{
    javino_link *link = &board->link;
#ifndef JAVINO_VERSION_1_ONLY
    const uint8_t most = (uint8_t)(PART_MAX - JAVINO_ITEM_HEADER);
#ifdef JAVINO_VERSION_2_ONLY
    if (!link->session)
        return false;
#endif
    rule(board, JAVINO_RULES_ALL);
    if (JAVINO_IS_2(link)) {
        link->answered = true;
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
#ifndef JAVINO_VERSION_2_ONLY
    if (length > JAVINO_MAX_PAYLOAD)
        return send_in_parts(link, text, length);
    javino_link_send(link, text, (uint8_t)length);
    return true;
#endif
}
