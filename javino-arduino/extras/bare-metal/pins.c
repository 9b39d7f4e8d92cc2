#include "pins.h"

#include <string.h>

#include "machine.h"

enum { INPUTS = PIN_COUNT - PIN_A0, CHANNELS = 16, SELECTS = 4, WORDS = 6, LINE = 64 };

typedef enum { INPUT, LOW, HIGH, PWM } kind;

static struct {
    kind kind;
    uint8_t duty;
    bool level; /* level of an input */
    bool watched;
} pins[PIN_COUNT];

/* The analogue inputs. A multiplexer gives an input several channels. */
static struct {
    uint16_t millivolts[CHANNELS];
    uint8_t selects[SELECTS];
    uint8_t select_count;
} inputs[INPUTS];

/* ---- Words ---- */

static void print(const char *text)
{
    while (*text)
        machine_put(MACHINE_PANEL, (uint8_t)*text++);
}

static void print_number(uint32_t number)
{
    char digits[11];
    char *p = digits + sizeof digits;
    *--p = 0;
    do {
        *--p = (char)('0' + number % 10);
        number /= 10;
    } while (number);
    print(p);
}

/* Reads a number and moves the pointer after it. Returns false if there is no number. */
static bool read_number(const char **text, uint16_t *number)
{
    const char *begin = *text;
    *number = 0;
    while (**text >= '0' && **text <= '9')
        *number = (uint16_t)(*number * 10 + (uint16_t)(*(*text)++ - '0'));
    return *text > begin;
}

/* Reads a pin such as 7, an analogue input such as A1, or a channel of an analogue input such as A1.2. */
static bool read_pin(const char *word, uint16_t *pin, uint16_t *channel)
{
    bool analogue = *word == 'A';
    word += analogue;
    *channel = 0;
    if (!read_number(&word, pin))
        return false;
    if (analogue)
        *pin += PIN_A0;
    if (analogue && *word == '.') {
        word++;
        if (!read_number(&word, channel))
            return false;
    }
    return *word == 0 && *pin < PIN_COUNT && *channel < CHANNELS;
}

/* ---- Pins ---- */

static void report(uint8_t pin)
{
    static const char *const NAMES[] = {" input", " low", " high", " pwm "};
    print("pin ");
    print_number(pin);
    print(NAMES[pins[pin].kind]);
    if (pins[pin].kind == PWM)
        print_number(pins[pin].duty);
    print(" ");
    print_number(machine_ms());
    print("\n");
}

static void change(uint8_t pin, kind kind, uint8_t duty)
{
    if (pins[pin].kind == kind && pins[pin].duty == duty)
        return;
    pins[pin].kind = kind;
    pins[pin].duty = duty;
    if (pins[pin].watched)
        report(pin);
}

void pin_output(uint8_t pin)
{
    if (pins[pin].kind == INPUT)
        change(pin, LOW, 0);
}

void pin_write(uint8_t pin, bool high)
{
    change(pin, high ? HIGH : LOW, 0);
}

void pin_pwm(uint8_t pin, uint8_t duty)
{
    if (duty == 0 || duty == 255)
        pin_write(pin, duty != 0);
    else
        change(pin, PWM, duty);
}

bool pin_read(uint8_t pin)
{
    return pins[pin].kind == INPUT ? pins[pin].level : pins[pin].kind == HIGH;
}

uint16_t pin_analogue(uint8_t pin)
{
    uint8_t input = (uint8_t)(pin - PIN_A0);
    uint8_t channel = 0;
    uint8_t i;
    for (i = 0; i < inputs[input].select_count; i++)
        if (pin_read(inputs[input].selects[i]))
            channel |= (uint8_t)(1u << i);
    return (uint16_t)(inputs[input].millivolts[channel] * 1023ul / 5000);
}

/* ---- Commands ---- */

static bool set(uint16_t pin, uint16_t channel, const char *value)
{
    uint16_t millivolts;
    bool high = strcmp(value, "high") == 0;
    if (high || strcmp(value, "low") == 0) {
        pins[pin].level = high;
        return true;
    }
    if (pin < PIN_A0 || !read_number(&value, &millivolts) || *value || millivolts > 5000)
        return false;
    inputs[pin - PIN_A0].millivolts[channel] = millivolts;
    return true;
}

static bool multiplex(uint16_t pin, char **words, uint8_t count)
{
    uint8_t i;
    uint16_t select;
    uint16_t channel;
    if (pin < PIN_A0 || count > SELECTS)
        return false;
    for (i = 0; i < count; i++) {
        if (!read_pin(words[i], &select, &channel))
            return false;
        inputs[pin - PIN_A0].selects[i] = (uint8_t)select;
    }
    inputs[pin - PIN_A0].select_count = count;
    return true;
}

static void carry_out(char **words, uint8_t count)
{
    uint16_t pin = 0;
    uint16_t channel = 0;
    bool done = false;
    if (count == 1 && strcmp(words[0], "time") == 0) {
        print("ok ");
        print_number(machine_ms());
        print("\n");
        return;
    }
    if (count > 1 && read_pin(words[1], &pin, &channel)) {
        if (count == 2 && strcmp(words[0], "watch") == 0) {
            pins[pin].watched = true;
            report((uint8_t)pin);
            return;
        }
        if (count == 3 && strcmp(words[0], "set") == 0)
            done = set(pin, channel, words[2]);
        else if (count > 2 && strcmp(words[0], "mux") == 0)
            done = multiplex(pin, words + 2, (uint8_t)(count - 2));
    }
    print(done ? "ok\n" : "error: not understood: ");
    if (!done) {
        print(words[0]);
        print("\n");
    }
}

static void read_line(char *line)
{
    char *words[WORDS];
    uint8_t count = 0;
    for (; *line && count < WORDS; line++) {
        if (*line == ' ')
            continue;
        words[count++] = line;
        while (*line && *line != ' ')
            line++;
        if (!*line)
            break;
        *line = 0;
    }
    if (count)
        carry_out(words, count);
}

void pins_poll(void)
{
    static char line[LINE];
    static uint8_t length;
    int byte;
    while ((byte = machine_take(MACHINE_PANEL)) >= 0) {
        if (byte == '\n') {
            line[length] = 0;
            length = 0;
            read_line(line);
        } else if (length < LINE - 1) {
            line[length++] = (char)byte;
        }
    }
}
