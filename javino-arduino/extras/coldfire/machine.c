/** @file A ColdFire MCF5208 without any library. QEMU emulates it with `qemu-system-m68k -M mcf5208evb`. The processor is big-endian. */
#include "start.h"

/* ---- Registers ---- */

#define REG8(address) (*(volatile uint8_t *)(address))
#define REG16(address) (*(volatile uint16_t *)(address))

#define UART_STATE(port) REG8(0xFC060004u + 0x4000u * (port))
#define UART_COMMAND(port) REG8(0xFC060008u + 0x4000u * (port))
#define UART_DATA(port) REG8(0xFC06000Cu + 0x4000u * (port))
#define UART_INTERRUPTS(port) REG8(0xFC060014u + 0x4000u * (port))
#define UART_DIVISOR_HIGH(port) REG8(0xFC060018u + 0x4000u * (port))
#define UART_DIVISOR_LOW(port) REG8(0xFC06001Cu + 0x4000u * (port))
enum { RX_READY = 1, TX_READY = 4, RX_AND_TX_ON = 5, RX_INTERRUPT = 2 };

#define TIMER_CONTROL REG16(0xFC080000)
#define TIMER_PERIOD REG16(0xFC080002)
enum { TIMER_ON = 1, TIMER_AGAIN = 2, TIMER_OVER = 4, TIMER_INTERRUPT = 8, TIMER_BY_16 = 0x400 };

#define INTERRUPT_LEVEL(number) REG8(0xFC048040u + (number))
#define INTERRUPT_PASS REG8(0xFC04801D)
enum { TIMER_NUMBER = 4, UART_NUMBER = 26 };

/* The clock rate of the timer and the ports. */
#define CLOCK_HZ 83333333u

/* ---- Interrupts ---- */

static void receive(uint8_t port)
{
    while (UART_STATE(port) & RX_READY)
        machine_receive(port, UART_DATA(port));
}

static __attribute__((interrupt)) void receive_line(void)
{
    receive(MACHINE_LINE);
}

static __attribute__((interrupt)) void receive_panel(void)
{
    receive(MACHINE_PANEL);
}

static __attribute__((interrupt)) void tick(void)
{
    TIMER_CONTROL |= TIMER_OVER;
    machine_tick();
}

/* ---- Start ---- */

typedef void (*function)(void);

/* The table holds exceptions, followed by interrupts in the order of their numbers. VBR requires an address that is a multiple of 1 MiB. */
enum { FIRST = 64, TIMER = FIRST + TIMER_NUMBER, LINE = FIRST + UART_NUMBER, PANEL = LINE + 1, VECTOR_COUNT = 128 };

__attribute__((section(".vectors"), used)) static const function VECTORS[VECTOR_COUNT] = {
    [2 ... TIMER - 1] = machine_halt, [TIMER] = tick,          [TIMER + 1 ... LINE - 1] = machine_halt,
    [LINE] = receive_line,            [PANEL] = receive_panel, [PANEL + 1 ... VECTOR_COUNT - 1] = machine_halt,
};

/* Masks all interrupts, sets the stack, and sets the address of the vectors. */
__asm__(".text\n"
        ".globl start\n"
        "start: move.w #0x2700, %sr\n"
        "lea stack_top, %sp\n"
        "move.l #VECTORS, %d0\n"
        "movec %d0, %vbr\n"
        "jmp machine_reset\n");

static void pass_interrupt(uint8_t number, uint8_t level)
{
    INTERRUPT_LEVEL(number) = level;
    INTERRUPT_PASS = number;
}

void machine_start(void)
{
    uint8_t port;
    pass_interrupt(TIMER_NUMBER, 3);
    TIMER_PERIOD = CLOCK_HZ / 16 / 1000 - 1;
    TIMER_CONTROL = TIMER_BY_16 | TIMER_INTERRUPT | TIMER_AGAIN | TIMER_ON;
    for (port = 0; port < MACHINE_PORTS; port++) {
        pass_interrupt((uint8_t)(UART_NUMBER + port), 2);
        UART_DIVISOR_HIGH(port) = 0;
        UART_DIVISOR_LOW(port) = (uint8_t)(CLOCK_HZ / 32 / MACHINE_BAUD);
        UART_INTERRUPTS(port) = RX_INTERRUPT;
        UART_COMMAND(port) = RX_AND_TX_ON;
    }
    __asm__ volatile("move.w #0x2000, %%sr" ::: "memory");
}

void machine_put(uint8_t port, uint8_t byte)
{
    while (!(UART_STATE(port) & TX_READY))
        ;
    UART_DATA(port) = byte;
}

void machine_sleep(void)
{
    __asm__ volatile("stop #0x2000" ::: "memory");
}
