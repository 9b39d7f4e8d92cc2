#include "board.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "avr_adc.h"
#include "avr_ioport.h"
#include "avr_uart.h"
#include "sim_elf.h"
#include "sim_hex.h"

/* Data addresses of the ATmega328P's registers. */
enum {
    ADMUX = 0x7C,
    UCSR0A = 0xC0,
    U2X0 = 1,
    UCSR0B = 0xC1,
    TXEN0 = 3,
    RXEN0 = 4,
    UBRR0L = 0xC4,
    UBRR0H = 0xC5
};

/* The cycles between two checks of the pins: a quarter of a millisecond. */
#define LOOK_CYCLES (BOARD_HZ / 4000)

/*
 * The pins that timers can drive. The fields are: the pin, the register and the bit that connect it to its timer, and the register with
 * the duty cycle.
 */
static const struct {
    int pin;
    uint16_t control;
    uint8_t connect;
    uint16_t compare;
} PWM[] = {
    {6, 0x44, 7, 0x47}, {5, 0x44, 5, 0x48},   /* OC0A, OC0B */
    {9, 0x80, 7, 0x88}, {10, 0x80, 5, 0x8A},  /* OC1A, OC1B */
    {11, 0xB0, 7, 0xB3}, {3, 0xB0, 5, 0xB4},  /* OC2A, OC2B */
};

static const struct {
    char letter;
    uint16_t ddr;
    uint16_t port;
    int first; /* Arduino's number of the pin at bit 0 */
    int pins;
} PORTS[] = {{'B', 0x24, 0x25, 8, 6}, {'C', 0x27, 0x28, 14, 6}, {'D', 0x2A, 0x2B, 0, 8}};

static int port_of(int pin)
{
    return pin < 8 ? 2 : pin < 14 ? 0 : 1;
}

int board_pin(const char *name)
{
    char *end;
    long number;
    int first = 0;
    int count = BOARD_PINS;
    if (toupper((unsigned char)name[0]) == 'A') {
        first = 14;
        count = 6;
        name++;
    } else if (toupper((unsigned char)name[0]) == 'P' && name[1]) {
        int port = toupper((unsigned char)name[1]) - 'B';
        if (port < 0 || port > 2)
            return -1;
        first = PORTS[port].first;
        count = PORTS[port].pins;
        name += 2;
    }
    number = strtol(name, &end, 10);
    return isdigit((unsigned char)*name) && *end == 0 && number < count ? first + (int)number : -1;
}

double board_ms(const board *board)
{
    return (double)board->avr->cycle * 1000.0 / BOARD_HZ;
}

/* ---- Pins ---- */

pin_state board_state(const board *board, int pin)
{
    const uint8_t *data = board->avr->data;
    int port = port_of(pin);
    uint8_t mask = (uint8_t)(1 << (pin - PORTS[port].first));
    pin_state state = {PIN_INPUT, 0};
    size_t i;
    if (!(data[PORTS[port].ddr] & mask))
        return state;
    for (i = 0; i < sizeof PWM / sizeof *PWM; i++)
        if (PWM[i].pin == pin && data[PWM[i].control] & 1 << PWM[i].connect) {
            state.kind = PIN_PWM;
            state.duty = data[PWM[i].compare];
            return state;
        }
    state.kind = data[PORTS[port].port] & mask ? PIN_HIGH : PIN_LOW;
    return state;
}

static void report(board *b, int pin)
{
    pin_state state = board_state(b, pin);
    if (!b->watched[pin] || (state.kind == b->last[pin].kind && state.duty == b->last[pin].duty))
        return;
    b->last[pin] = state;
    b->watcher(b->context, pin, state, board_ms(b));
}

/* Runs a few cycles after a write, because simavr reports a write before the register changes. */
static avr_cycle_count_t look(avr_t *avr, avr_cycle_count_t when, void *context)
{
    int pin;
    (void)avr;
    (void)when;
    for (pin = 0; pin < BOARD_PINS; pin++)
        report((board *)context, pin);
    return 0;
}

static void drive_inputs(board *b);

static void port_written(avr_irq_t *irq, uint32_t value, void *context)
{
    board *b = (board *)context;
    (void)irq;
    (void)value;
    avr_cycle_timer_register(b->avr, 4, look, b);
    drive_inputs(b);
}

void board_watch(board *board, int pin)
{
    board->watched[pin] = true;
    board->last[pin] = board_state(board, pin);
    board->watcher(board->context, pin, board->last[pin], board_ms(board));
}

avr_irq_t *board_irq(const board *board, int pin)
{
    int port = port_of(pin);
    return avr_io_getirq(board->avr, AVR_IOCTL_IOPORT_GETIRQ(PORTS[port].letter), pin - PORTS[port].first);
}

static bool has_bit(const board *board, uint16_t address, int pin)
{
    return board->avr->data[address] >> (pin - PORTS[port_of(pin)].first) & 1;
}

/* Reads the register of a port's inputs, whose address is one less than that of the direction register. */
bool board_level(const board *board, int pin)
{
    return has_bit(board, (uint16_t)(PORTS[port_of(pin)].ddr - 1), pin);
}

bool board_pulls_up(const board *board, int pin)
{
    return has_bit(board, PORTS[port_of(pin)].port, pin);
}

/*
 * Tells simavr the external level of each pin of a port. Otherwise each write to the port makes simavr reset an input to its pull-up
 * level.
 */
static void pull_from_outside(board *board, int port)
{
    avr_ioport_external_t outside = {0};
    int i;
    outside.name = (unsigned char)PORTS[port].letter;
    for (i = 0; i < PORTS[port].pins; i++) {
        int level = board->levels[PORTS[port].first + i];
        outside.mask |= (level != 0) << i;
        outside.value |= (level == 2) << i;
    }
    avr_ioctl(board->avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(PORTS[port].letter), &outside);
}

void board_set_level(board *board, int pin, bool high)
{
    board->levels[pin] = high ? 2 : 1;
    pull_from_outside(board, port_of(pin));
    avr_raise_irq(board_irq(board, pin), high);
}

/* A reset clears the input registers, and simavr reports only changes of levels. Therefore sets the bits of high inputs again. */
static void restore_levels(board *board)
{
    int pin;
    for (pin = 0; pin < BOARD_PINS; pin++)
        if (board->levels[pin] == 2)
            board->avr->data[PORTS[port_of(pin)].ddr - 1] |= (uint8_t)(1 << (pin - PORTS[port_of(pin)].first));
}

/* ---- Analogue inputs ---- */

static int selected(const board *b, int input)
{
    int channel = 0;
    int i;
    for (i = 0; i < BOARD_SELECTS; i++)
        if (b->select_pins[input][i] >= 0 && board_state(b, b->select_pins[input][i]).kind == PIN_HIGH)
            channel |= 1 << i;
    return channel;
}

static void drive_input(board *b, int input)
{
    avr_raise_irq(avr_io_getirq(b->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0 + input), b->millivolts[input][selected(b, input)]);
}

static void drive_inputs(board *b)
{
    int input;
    for (input = 0; input < BOARD_ANALOGUE; input++)
        drive_input(b, input);
}

/* Called when a conversion begins. Puts the voltage of the selected channel on each analogue input. */
static void conversion(avr_irq_t *irq, uint32_t value, void *context)
{
    board *b = (board *)context;
    int input = b->avr->data[ADMUX] & 0x0F;
    (void)irq;
    (void)value;
    if (input < BOARD_ANALOGUE)
        b->converted[input] = true;
    drive_inputs(b);
}

void board_set_millivolts(board *board, int input, int channel, uint16_t millivolts)
{
    board->millivolts[input][channel] = millivolts;
    drive_input(board, input);
}

void board_multiplex(board *board, int input, const int *select_pins, int count)
{
    int i;
    for (i = 0; i < BOARD_SELECTS; i++)
        board->select_pins[input][i] = i < count ? select_pins[i] : -1;
    drive_input(board, input);
}

/* ---- The serial line ---- */

static avr_uart_t *uart(const board *b)
{
    avr_io_t *io = b->avr->io_port;
    while (io && strcmp(io->kind, "uart") != 0)
        io = io->next;
    return (avr_uart_t *)io;
}

/* A byte takes ten bit times, but simavr assumes eleven. Corrects simavr's value with every byte. */
static avr_cycle_count_t byte_cycles(const board *b)
{
    const uint8_t *data = b->avr->data;
    unsigned divisor = (unsigned)(data[UBRR0L] | data[UBRR0H] << 8) + 1;
    return uart(b)->cycles_per_byte = 10ull * divisor * (data[UCSR0A] & 1 << U2X0 ? 8 : 16);
}

unsigned board_baud(const board *board)
{
    bool is_on = board->avr->data[UCSR0B] & (1 << RXEN0 | 1 << TXEN0);
    return is_on ? (unsigned)(10ull * BOARD_HZ / byte_cycles(board)) : 0;
}

static avr_cycle_count_t feed(avr_t *avr, avr_cycle_count_t when, void *context)
{
    board *b = (board *)context;
    avr_cycle_count_t byte = byte_cycles(b);
    (void)avr;
    b->feeding = b->in_begin != b->in_end;
    if (!b->feeding)
        return 0;
    if (b->in_at[b->in_begin] > when)
        return b->in_at[b->in_begin];
    if (b->receiver_full)
        return when + byte / 8;
    avr_raise_irq(avr_io_getirq(b->avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), b->in[b->in_begin]);
    b->in_begin = (b->in_begin + 1) % sizeof b->in;
    return b->in_begin != b->in_end && b->in_at[b->in_begin] ? b->in_at[b->in_begin] : when + byte;
}

/* Bytes for the board wait here while simavr's receiver is full. simavr takes bytes more slowly than the line brings them, and drops
 * bytes that exceed its queue. */
static void receiver_changed(avr_irq_t *irq, uint32_t value, void *context)
{
    (void)value;
    ((board *)context)->receiver_full = irq->irq == UART_IRQ_OUT_XOFF;
}

unsigned board_room(const board *board)
{
    return (unsigned)((board->in_begin + sizeof board->in - board->in_end - 1) % sizeof board->in);
}

static void put(board *board, uint8_t byte, uint64_t cycle, avr_cycle_count_t delay)
{
    board->in[board->in_end] = byte;
    board->in_at[board->in_end] = cycle;
    board->in_end = (board->in_end + 1) % sizeof board->in;
    if (!board->feeding) {
        board->feeding = true;
        avr_cycle_timer_register(board->avr, delay, feed, board);
    }
}

void board_receive(board *board, uint8_t byte)
{
    put(board, byte, 0, byte_cycles(board));
}

/* simavr delivers a byte one byte time after it has received the byte. */
void board_receive_at(board *board, uint8_t byte, uint64_t cycle)
{
    uint64_t now = board->avr->cycle;
    put(board, byte, cycle, cycle > now ? cycle - now : 0);
}

void board_foretell(board *board, byte_forecast forecast)
{
    board->forecast = forecast;
}

static avr_cycle_count_t send(avr_t *avr, avr_cycle_count_t when, void *context)
{
    board *b = (board *)context;
    (void)avr;
    b->sink(b->context, b->out[b->out_begin]);
    b->out_begin = (b->out_begin + 1) % sizeof b->out;
    b->sending = b->out_begin != b->out_end;
    return b->sending ? when + byte_cycles(b) : 0;
}

static void written(avr_irq_t *irq, uint32_t value, void *context)
{
    board *b = (board *)context;
    (void)irq;
    if (b->forecast) {
        b->out_free = (b->out_free > b->avr->cycle ? b->out_free : b->avr->cycle) + byte_cycles(b);
        b->forecast(b->context, (uint8_t)value, b->out_free);
        return;
    }
    b->out[b->out_end] = (uint8_t)value;
    b->out_end = (b->out_end + 1) % sizeof b->out;
    if (!b->sending) {
        b->sending = true;
        avr_cycle_timer_register(b->avr, byte_cycles(b), send, b);
    }
}

/* ---- The processor ---- */

static void no_log(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

static void no_sleep(avr_t *avr, avr_cycle_count_t cycles)
{
    (void)avr;
    (void)cycles;
}

static bool load_hex(elf_firmware_t *firmware, const char *path)
{
    uint32_t size;
    uint32_t base;
    firmware->flash = read_ihex_file(path, &size, &base);
    firmware->flashsize = size;
    firmware->flashbase = base;
    return firmware->flash != NULL;
}

static bool ends_in(const char *text, const char *end)
{
    size_t n = strlen(text);
    return n >= strlen(end) && strcmp(text + n - strlen(end), end) == 0;
}

static bool is_readable(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file)
        fclose(file);
    return file != NULL;
}

bool board_load(board *board, const char *firmware, pin_watcher watcher, byte_sink sink, void *context)
{
    elf_firmware_t sketch;
    uint32_t flags = 0;
    int port;
    memset(board, 0, sizeof *board);
    memset(board->select_pins, -1, sizeof board->select_pins);
    memset(&sketch, 0, sizeof sketch);
    avr_global_logger_set(no_log);
    if (!is_readable(firmware) ||
        !(ends_in(firmware, ".hex") ? load_hex(&sketch, firmware) : elf_read_firmware(firmware, &sketch) == 0)) {
        fprintf(stderr, "simulator: %s is no .elf or .hex file that can be read\n", firmware);
        return false;
    }
    board->avr = avr_make_mcu_by_name("atmega328p");
    if (!board->avr) {
        fprintf(stderr, "simulator: this simavr has no ATmega328P\n");
        return false;
    }
    board->watcher = watcher;
    board->sink = sink;
    board->context = context;
    avr_init(board->avr);
    sketch.frequency = (uint32_t)BOARD_HZ;
    sketch.vcc = sketch.avcc = sketch.aref = 5000;
    avr_load_firmware(board->avr, &sketch);
    board->avr->frequency = (uint32_t)BOARD_HZ;
    board->avr->sleep = no_sleep;
    avr_ioctl(board->avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(board->avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), written, board);
    avr_irq_register_notify(avr_io_getirq(board->avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), receiver_changed, board);
    avr_irq_register_notify(avr_io_getirq(board->avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), receiver_changed, board);
    for (port = 0; port < 3; port++) {
        uint32_t name = AVR_IOCTL_IOPORT_GETIRQ(PORTS[port].letter);
        avr_irq_register_notify(avr_io_getirq(board->avr, name, IOPORT_IRQ_REG_PORT), port_written, board);
        avr_irq_register_notify(avr_io_getirq(board->avr, name, IOPORT_IRQ_DIRECTION_ALL), port_written, board);
    }
    avr_irq_register_notify(avr_io_getirq(board->avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), conversion, board);
    return true;
}

static bool run(board *b, uint64_t cycle)
{
    while (b->avr->cycle < cycle) {
        int state = avr_run(b->avr);
        if (state == cpu_Done || state == cpu_Crashed)
            return false;
    }
    return true;
}

/* Checks the pins every LOOK_CYCLES, because simavr does not report writes to a timer's compare register. */
bool board_run(board *board, uint64_t cycle)
{
    int pin;
    while (board->avr->cycle < cycle) {
        uint64_t next = board->avr->cycle + LOOK_CYCLES;
        if (!run(board, next < cycle ? next : cycle))
            return false;
        for (pin = 0; pin < BOARD_PINS; pin++)
            report(board, pin);
    }
    return true;
}

void board_reset(board *board)
{
    avr_cycle_count_t now = board->avr->cycle;
    avr_reset(board->avr);
    board->avr->cycle = now;
    board->in_begin = board->in_end = board->out_begin = board->out_end = 0;
    board->feeding = board->sending = board->receiver_full = false;
    board->out_free = 0;
    restore_levels(board);
}
