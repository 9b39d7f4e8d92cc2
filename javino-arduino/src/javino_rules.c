#include "javino_rules.h"

#ifndef JAVINO_VERSION_1_ONLY

#include <string.h>

#include "javino_items.h"
#include "javino_literal.h"

#define UNTIL 1 /* separates two values */
#define REFLEX 2 /* precedes a reflex */

#define ALIGNMENT sizeof(void *)

/* The outcome of a reflex. */
enum { NO_REFLEX, CARRIED_OUT, NOT_CARRIED_OUT };

/* The longest percept in CRITICAL, in bytes. */
#define PERCEPT_MAX (JAVINO_MAX_PAYLOAD - 2)

/* ---- Numbers ---- */

static uint8_t digits(const char *text, uint8_t length)
{
    uint8_t n = 0;
    while (n < length && text[n] >= '0' && text[n] <= '9')
        n++;
    return n;
}

static bool is_number(const char *text, uint8_t length)
{
    uint8_t sign = length && (*text == '-' || *text == '+');
    uint8_t n = sign + digits(text + sign, length - sign);
    if (n > sign && n < length && text[n] == '.') {
        uint8_t decimals = digits(text + n + 1, length - n - 1);
        n += decimals ? decimals + 1 : 0;
    }
    return n > sign && n == length;
}

/* A number without its sign. */
typedef struct {
    const char *text;
    uint8_t length;
    uint8_t whole; /* digits before the point, without leading zeros */
    bool negative;
} decimal;

static void read_decimal(decimal *d, const char *text, uint8_t length)
{
    d->negative = *text == '-';
    if (*text == '-' || *text == '+') {
        text++;
        length--;
    }
    while (length && *text == '0') {
        text++;
        length--;
    }
    d->text = text;
    d->length = length;
    d->whole = digits(text, length);
}

static char digit_at(const decimal *d, uint8_t i)
{
    return i < d->length ? d->text[i] : '0';
}

/* Returns a number below 0 if a < b, 0 if they are equal, and a number above 0 if a > b. */
static int8_t compare(const decimal *a, const decimal *b)
{
    bool zero = true;
    int8_t order = 0;
    uint8_t i;
    if (a->whole != b->whole) {
        order = a->whole < b->whole ? -1 : 1;
        zero = false;
    } else {
        for (i = 0; i < a->length || i < b->length; i++) {
            char x = digit_at(a, i);
            char y = digit_at(b, i);
            if (i == a->whole)
                continue; /* the point */
            if (x != '0' || y != '0')
                zero = false;
            if (x != y && !order)
                order = x < y ? -1 : 1;
        }
    }
    if (zero || !(a->negative || b->negative))
        return order;
    if (a->negative && b->negative)
        return -order;
    return a->negative ? -1 : 1;
}

/* ---- One rule, in bytes: its number; its functor and 00; any number of conditions, each "position operator value [01 value] 00" (the
   position of an argument); perhaps 02 and a reflex ---- */

static bool is_operator(char c, bool number)
{
    return c == '=' || c == '!' || (number && (c == '<' || c == '>' || c == '{' || c == '}'));
}

/* Returns the length of a word before its 00. Returns 0 if there is no 00. */
static uint8_t word(const char *text, const char *end)
{
    const char *p = text;
    while (p < end && *p)
        p++;
    return p < end ? (uint8_t)(p - text) : 0;
}

/* Returns the length of the first of one or two values. */
static uint8_t first_value(const char *values, uint8_t length)
{
    uint8_t n = 0;
    while (n < length && values[n] != UNTIL)
        n++;
    return n;
}

/* Returns true if the text is a condition. `length`: length of its values in bytes. */
static bool is_condition(const char *text, uint8_t length)
{
    const char *values = text + 2;
    uint8_t first = first_value(values, length);
    bool number = is_number(values, first);
    if (!first || first + 1 == length)
        return false;
    if (first < length)
        number = number && is_number(values + first + 1, (uint8_t)(length - first - 1));
    return *text >= '1' && *text <= '9' && is_operator(text[1], number);
}

static bool is_rule(const char *text, const char *end)
{
    uint8_t n = word(++text, end);
    if (!n)
        return false;
    for (text += n + 1; text < end && *text != REFLEX; text += n + 3) {
        if (end - text < 4)
            return false;
        n = word(text + 2, end);
        if (!is_condition(text, n))
            return false;
    }
    return text == end || text + 1 < end;
}

/*
 * Returns true if an argument matches a condition with `length` bytes of values. If `met`, the rule matched before, so a second value is
 * used.
 */
static bool holds(const char *condition, uint8_t length, bool met, const char *text, uint8_t text_length)
{
    char how = condition[1];
    const char *value = condition + 2;
    uint8_t first = first_value(value, length);
    const char *argument;
    uint8_t n = javino_argument(text, text_length, (uint8_t)(*condition - '1'), &argument);
    bool number = n && is_number(argument, n);
    int8_t order;
    decimal a, b; /* sdcc cannot pass structs by value */
    if (met && first < length) {
        value += first + 1;
        length -= first + 1;
    } else {
        length = first;
    }
    if (!n || number != is_number(value, length))
        return how == '!';
    if (number) {
        read_decimal(&a, argument, n);
        read_decimal(&b, value, length);
        order = compare(&a, &b);
    } else {
        order = n != length || memcmp(argument, value, n) != 0;
    }
    switch (how) {
    case '<': return order < 0;
    case '>': return order > 0;
    case '{': return order <= 0;
    case '}': return order >= 0;
    case '=': return order == 0;
    default: return order != 0;
    }
}

/* Returns true if a percept matches a rule. `met` tells whether the rule matched at the last look. Sets reflex to the beginning of the
 * rule's reflex, or to the rule's end. */
static bool meets(const char *rule, const char *end, bool met, const char *text, uint8_t length, const char **reflex)
{
    uint8_t n = (uint8_t)strlen(++rule);
    if (n != javino_word(text, length) || memcmp(rule, text, n) != 0)
        return false;
    for (rule += n + 1; rule < end && *rule != REFLEX; rule += n + 3) {
        n = (uint8_t)strlen(rule + 2);
        if (!holds(rule, n, met, text, length))
            return false;
    }
    *reflex = rule < end ? rule + 1 : end;
    return true;
}

/* ---- All rules ---- */

/* Removes a bit. Lower bits stay, higher bits move down. */
static uint8_t without_bit(uint8_t bits, uint8_t bit)
{
    uint8_t below = bits & (uint8_t)(bit - 1);
    return below | ((bits >> 1) & (uint8_t)~(bit - 1));
}

/* Returns the index of the rule with this number, or the end of all rules. Sets `bit` to the rule's bit in `met`. */
static uint16_t place_of(const struct javino_rules *r, uint8_t number, uint8_t *bit)
{
    uint16_t at = 0;
    for (*bit = 1; at < r->used && r->texts[at + 1] != number; at += r->texts[at] + 1u)
        *bit = (uint8_t)(*bit << 1);
    return at;
}

static void forget(struct javino_rules *r)
{
    r->used = r->met = 0;
}

/* Sets or removes rules according to the present command. Returns false if the command is malformed, or if there is no room. */
static bool set(javino_board *board)
{
    struct javino_rules *r = board->rules;
    javino_link *l = &board->link;
    const char *text = l->text;
    uint8_t length = l->length;
    uint8_t number = (uint8_t)*text;
    uint16_t at;
    uint16_t before; /* length of the replaced rule in bytes */
    uint8_t bit;
    if (l->rules == 0)
        forget(r); /* a session has begun since the last command */
    if (number == 0 && length == 1) {
        l->rules = 0;
        forget(r);
        return true;
    }
    if (number == 0 || (length > 1 && !is_rule(text, text + length)))
        return false;
    at = place_of(r, number, &bit);
    before = at < r->used ? r->texts[at] + 1u : 0;
    if (length > 1 && (r->used - before + length + 1u > r->size || l->rules - (before != 0) >= JAVINO_RULES_MAX))
        return false;
    if (before) {
        r->used -= before;
        memmove(r->texts + at, r->texts + at + before, r->used - at);
        r->met = without_bit(r->met, bit);
        l->rules--;
    }
    if (length > 1) {
        r->texts[r->used] = length;
        memcpy(r->texts + r->used + 1, text, length);
        r->used += length + 1u;
        l->rules++;
    }
    return true;
}

/* ---- Looking ---- */

static bool wants(const javino_board *b, const char *functor, uint8_t length)
{
    const struct javino_rules *r = b->rules;
    uint16_t at;
    for (at = 0; at < r->used; at += r->texts[at] + 1u) {
        const char *name = (const char *)r->texts + at + 2;
        if (*name == '~')
            name++;
        if (strlen(name) == length && memcmp(name, functor, length) == 0)
            return true;
    }
    return false;
}

/* Carries a reflex out. Percepts that the program writes meanwhile wait as unasked percepts. */
static uint8_t react(javino_board *b, const char *reflex, const char *end)
{
    uint8_t request = b->link.request;
    bool done;
    if (reflex == end)
        return NO_REFLEX;
    b->link.event = JAVINO_NOTHING;
    b->link.request = 0;
    done = b->rules->act(b->link.encoder.context, reflex, (uint8_t)(end - reflex));
    b->link.event = JAVINO_WATCH;
    b->link.request = request;
    return done ? CARRIED_OUT : NOT_CARRIED_OUT;
}

static void report(javino_board *b, uint8_t number, uint8_t outcome, const char *text, uint8_t length)
{
    javino_encoder *e = &b->link.encoder;
    javino_link_begin(&b->link, JAVINO_CRITICAL, (uint8_t)(length + 2));
    javino_encoder_put(e, number);
    javino_encoder_put(e, outcome);
    javino_encoder_finish(e, text, length);
}

/* Compares the newest percept with all rules. The newest percept is stored after the whole percepts. */
static void watch(javino_board *b)
{
    struct javino_rules *r = b->rules;
    javino_room begin = b->whole;
    javino_room end = b->length;
    uint16_t at = 0;
    uint8_t bit;
    if (end - begin - JAVINO_ITEM_HEADER > PERCEPT_MAX)
        return;
    b->whole = end; /* The percept must stay in place during the comparison. */
    for (bit = 1; at < r->used; at += r->texts[at] + 1u, bit = (uint8_t)(bit << 1)) {
        const char *rule = (const char *)r->texts + at + 1;
        const char *rule_end = rule + r->texts[at];
        const char *text = b->text + begin + JAVINO_ITEM_HEADER;
        uint8_t length = (uint8_t)(end - begin - JAVINO_ITEM_HEADER);
        const char *reflex;
        if (r->seen & bit || !meets(rule, rule_end, (r->met & bit) != 0, text, length - 1, &reflex))
            continue;
        r->seen |= bit;
        if (!(r->met & bit)) {
            uint8_t outcome = react(b, reflex, rule_end);
            report(b, (uint8_t)*rule, outcome, b->text + begin + JAVINO_ITEM_HEADER, length);
        }
    }
    if (b->length < end)
        return; /* The program has cleared the percepts. */
    memmove(b->text + begin, b->text + end, b->length - end);
    b->length -= end - begin;
    b->whole -= end - begin;
}

static JAVINO_NOINLINE void look(javino_board *b)
{
    struct javino_rules *r = b->rules;
    javino_link *l = &b->link;
    javino_event event = l->event;
    r->seen = 0;
    l->event = JAVINO_WATCH;
    r->perceive(l->encoder.context);
    l->event = event;
    r->met = r->seen;
}

void javino_rules_look(javino_board *board, javino_perceive perceive, uint16_t now_ms)
{
    struct javino_rules *r = board->rules;
    if (!r || !board->link.rules || (uint16_t)(now_ms - r->looked_ms) < JAVINO_RULES_MS)
        return;
    r->looked_ms = now_ms;
    r->perceive = perceive;
    look(board);
}

/* ---- Answers in parts ---- */

/* Sends the next part of an answer. The answer belongs to an earlier request than the present message. */
static void send_next(javino_board *b)
{
    javino_link *l = &b->link;
    bool last;
    bool answered = l->answered;
    uint8_t request = l->request;
    b->length = b->whole;
    javino_items_code(b);
    l->request = b->answering;
    last = b->whole <= JAVINO_SHORT_PART;
    javino_board_send_text(b, last, last ? b->whole : JAVINO_SHORT_PART);
    l->answered = answered;
    l->request = request;
    if (last)
        javino_board_clear(b);
}

/* Divides the rest of the memory until the last part of the answer has gone out. The space before the answer is for frames. The space
 * after it is for percepts to compare. */
static void make_room(javino_board *b)
{
    uint16_t left = b->memory - b->length;
    uint16_t percept = left / 2 < JAVINO_TEXT_MIN ? left / 2 : JAVINO_TEXT_MIN;
    uint16_t place = left - percept;
    uint16_t arrived = b->link.decoder.end;
    if (place > JAVINO_WINDOW)
        place = JAVINO_WINDOW;
    javino_board_place(b, place < arrived ? arrived : place);
}

/* Returns true if the answer now goes out in parts, or if unasked percepts join such an answer. */
static bool answer(javino_board *b)
{
    javino_link *l = &b->link;
    if (l->event == JAVINO_REQUEST && JAVINO_IS_2(l) && l->rules && b->length > JAVINO_SHORT_PART) {
        b->answering = l->request;
        b->rules->session = l->session;
        l->request = 0;
        l->event = JAVINO_NOTHING;
        make_room(b);
    }
    return b->answering != 0;
}

/* If `where` is JAVINO_RULES_GO_ON, sends the next part of the answer if the line is free. With any other `where`, sends all remaining
 * parts. Returns false if no answer is going out. */
static bool go_on(javino_board *b, uint8_t where)
{
    bool all = where != JAVINO_RULES_GO_ON;
    const struct javino_rules *r = b->rules;
    if (!b->answering)
        return false;
    if (r->session != b->link.session) {
        b->part = 0;
        javino_board_clear(b);
        return false;
    }
    if (all || !r->is_free || r->is_free(b->link.encoder.context))
        do {
            send_next(b);
            /* A part may have waited for the line. */
            if (where == JAVINO_RULES_END && r->perceive)
                look(b);
        } while (all && b->answering);
    return true;
}

static bool take_part(javino_board *b, uint8_t where)
{
    switch (where) {
    case JAVINO_RULES_SET: javino_link_finish(&b->link, set(b)); return true;
    case JAVINO_RULES_PERCEPT: watch(b); return true;
    case JAVINO_RULES_ANSWER: return answer(b);
    case JAVINO_RULES_END:
        go_on(b, where);
        /* true if percepts can be compared in the memory after the new answer */
        return b->link.rules && b->memory - b->link.decoder.end >= 2 * JAVINO_TEXT_MIN;
    default: return go_on(b, where);
    }
}

bool javino_rules_init(javino_board *board, uint8_t size, javino_act act, bool (*is_free)(void *context))
{
    struct javino_rules *r;
    uint16_t bytes = (uint16_t)(sizeof *r + size + 2 * ALIGNMENT - 2);
    uint8_t *memory;
    bytes -= bytes % ALIGNMENT;
    memory = javino_board_take_front(board, bytes); /* At the front, because the program's actions are at the end, without a gap. */
    if (!memory)
        return false;
    r = (struct javino_rules *)(memory + (ALIGNMENT - (uintptr_t)memory % ALIGNMENT) % ALIGNMENT);
    memset(r, 0, sizeof *r);
    r->act = act;
    r->is_free = is_free;
    r->texts = (uint8_t *)(r + 1);
    r->size = size;
    board->rules = r;
    board->rule = take_part;
    board->watches = wants;
    board->link.rules_max = JAVINO_RULES_MAX;
    return true;
}

#endif
