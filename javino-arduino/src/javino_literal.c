#include "javino_literal.h"

/* Returns the kind of a bracket: 1 for round brackets, 2 for square ones, 3 for braces. */
static uint8_t kind_of(char bracket)
{
    return bracket < 'A' ? 1 : bracket < 'a' ? 2 : 3;
}

bool javino_outside(javino_nesting *nesting, char c)
{
    javino_nesting *n = nesting;
    if (n->quote) {
        if (n->escaped)
            n->escaped = false;
        else if (c == '\\' && n->quote == '"')
            n->escaped = true; /* Quoted atoms have no escapes. */
        else if (c == n->quote)
            n->quote = 0;
        return false;
    }
    switch (c) {
    case '"':
    case '\'':
        n->quote = c;
        return false;
    case '(':
    case '[':
    case '{':
        n->depth++;
        n->kinds = n->kinds << 2 | kind_of(c);
        return false;
    case ')':
    case ']':
    case '}':
        /* `kinds` covers only the innermost sixteen brackets. */
        if (n->depth == 0 || ((n->kinds & 3) != kind_of(c) && n->kinds))
            n->crossed = true;
        if (n->depth)
            n->depth--;
        n->kinds >>= 2;
        return false;
    default:
        return n->depth == 0;
    }
}

uint8_t javino_word(const char *text, uint8_t length)
{
    uint8_t n = 0;
    while (n < length && text[n] && text[n] != '(' && text[n] != '[')
        n++;
    return n;
}

/* Returns true if an item is missing between two consecutive characters outside of quotes. */
static bool is_empty_place(char before, char c)
{
    bool begins = before == ',' || before == '(' || before == '[';
    return (c == ',' && begins) || ((c == ')' || c == ']') && before == ',');
}

uint8_t javino_functor(const char *text, uint8_t length)
{
    javino_nesting n = {0, 0, false, false, 0};
    uint8_t word = javino_word(text, length);
    char before = 0;
    uint8_t i;
    for (i = 0; i < length; i++) {
        char c = text[i];
        bool top = n.depth == 0;
        bool quoted = n.quote != 0;
        bool outside = javino_outside(&n, c);
        bool opens = i == word || (c == '[' && text[i - 1] == ')');
        if (i < word ? !outside : top && (outside || !opens))
            return 0;
        if (n.crossed || (!quoted && is_empty_place(before, c)))
            return 0;
        if (quoted || c != ' ')
            before = quoted ? '"' : c;
    }
    return n.depth == 0 ? word : 0;
}

uint8_t javino_argument(const char *text, uint8_t length, uint8_t index, const char **argument)
{
    javino_nesting n = {0, 0, false, false, 0};
    const char *end = text + length;
    const char *begin;
    text += javino_word(text, length);
    if (text == end || *text == '[')
        return 0;
    for (begin = ++text; text < end; text++) {
        if (n.depth || n.quote || (*text != ',' && *text != ')')) {
            javino_outside(&n, *text);
            continue;
        }
        if (index == 0) {
            while (begin < text && *begin == ' ')
                begin++;
            *argument = begin;
            while (text > begin && text[-1] == ' ')
                text--;
            return (uint8_t)(text - begin);
        }
        if (*text == ')')
            break;
        index--;
        begin = text + 1;
    }
    return 0;
}

bool javino_number(const char *text, uint8_t length, int32_t *number)
{
    const char *end = text + length;
    bool negative = length && *text == '-';
    uint32_t value = 0;
    if (length && (*text == '-' || *text == '+'))
        text++;
    if (text == end)
        return false;
    for (; text < end; text++) {
        uint8_t digit = (uint8_t)(*text - '0');
        if (digit > 9 || value > 214748364u)
            return false;
        value = value * 10 + digit;
    }
    if (value > 2147483647u + negative)
        return false;
    *number = (int32_t)(negative ? 0 - value : value);
    return true;
}
