#include "javino_literal.h"

bool javino_outside(javino_nesting *nesting, char c)
{
    javino_nesting *n = nesting;
    if (n->quote) {
        if (n->escaped)
            n->escaped = false;
        else if (c == '\\')
            n->escaped = true;
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
        return false;
    case ')':
    case ']':
    case '}':
        if (n->depth)
            n->depth--;
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

uint8_t javino_functor(const char *text, uint8_t length)
{
    javino_nesting n = {0, 0, false};
    const char *end = text + length;
    const char *word = text + javino_word(text, length);
    const char *p;
    for (p = text; p < end; p++) {
        bool top = n.depth == 0;
        bool outside = javino_outside(&n, *p);
        if (p < word ? !outside : top && !(p == word || (*p == '[' && p[-1] == ')')))
            return 0;
    }
    return n.depth == 0 ? (uint8_t)(word - text) : 0;
}

uint8_t javino_argument(const char *text, uint8_t length, uint8_t index, const char **argument)
{
    javino_nesting n = {0, 0, false};
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
