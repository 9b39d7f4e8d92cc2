/**
 * @file A Cortex-M3 without any library: ARM's MPS2 board with the AN385 image. QEMU emulates it with `qemu-system-arm -M mps2-an385`.
 *     For another Cortex-M, keep the vectors and the clock, and change the UART's registers, the clock's rate and the interrupt numbers.
 */
#include "start.h"

#define CLOCK_HZ 25000000u

/* ---- Registers ---- */

typedef volatile uint32_t reg;

/* CMSDK APB UART. */
typedef struct {
    reg data;
    reg state;     /* bit 0: the transmitter is full; bit 1: the receiver is full */
    reg control;   /* bit 0: transmitter on, 1: receiver on, 3: receive interrupt on */
    reg interrupt; /* writing bit 1 ends the receive interrupt */
    reg divisor;
} uart;

enum { TX_FULL = 1, RX_FULL = 2, TX_ON = 1, RX_ON = 2, RX_INTERRUPT_ON = 8, RX_INTERRUPT = 2 };

static uart *const UARTS[MACHINE_PORTS] = {(uart *)0x40004000, (uart *)0x40005000};
enum { UART0_INTERRUPT = 0, UART1_INTERRUPT = 2 };

#define SYSTICK_CONTROL (*(reg *)0xE000E010)
#define SYSTICK_RELOAD (*(reg *)0xE000E014)
#define SYSTICK_VALUE (*(reg *)0xE000E018)
#define INTERRUPTS_ON (*(reg *)0xE000E100)

/* ---- Interrupts ---- */

static void receive(uint8_t port)
{
    UARTS[port]->interrupt = RX_INTERRUPT;
    while (UARTS[port]->state & RX_FULL)
        machine_receive(port, (uint8_t)UARTS[port]->data);
}

static void receive_line(void)
{
    receive(MACHINE_LINE);
}

static void receive_panel(void)
{
    receive(MACHINE_PANEL);
}

/* ---- Start ---- */

extern uint32_t stack_top[];
typedef void (*function)(void);

/*
 * The table that the processor reads at address 0. The table holds the stack, the first function, and a function for each exception and
 * interrupt.
 */
typedef struct {
    uint32_t *stack;
    function exceptions[15];
    function interrupts[32];
} vector_table;

__attribute__((section(".vectors"), used)) static const vector_table VECTORS = {
    stack_top,
    {machine_reset, machine_halt, machine_halt, machine_halt, machine_halt, machine_halt, 0, 0, 0, 0, machine_halt, machine_halt, 0,
     machine_halt, machine_tick},
    {[UART0_INTERRUPT] = receive_line, [UART1_INTERRUPT] = receive_panel},
};

void machine_start(void)
{
    uint8_t port;
    for (port = 0; port < MACHINE_PORTS; port++) {
        UARTS[port]->divisor = CLOCK_HZ / MACHINE_BAUD;
        UARTS[port]->control = TX_ON | RX_ON | RX_INTERRUPT_ON;
    }
    SYSTICK_RELOAD = CLOCK_HZ / 1000 - 1;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 7; /* bits: the processor's clock, interrupt, on */
    INTERRUPTS_ON = 1u << UART0_INTERRUPT | 1u << UART1_INTERRUPT;
}

void machine_put(uint8_t port, uint8_t byte)
{
    while (UARTS[port]->state & TX_FULL)
        ;
    UARTS[port]->data = byte;
}

void machine_sleep(void)
{
    __asm__ volatile("wfi");
}
