/**
 * @file A RISC-V microcontroller without any library: SiFive's FE310 (RV32IMAC, 16 KB of RAM). QEMU emulates it with
 *     `qemu-system-riscv32 -M sifive_e`. For another RISC-V, keep the first instructions, and change the UART's registers, the clock's
 *     address and rate, and the interrupt numbers.
 */
#include "start.h"

#define CLOCK_HZ 16000000u

/* ---- Registers ---- */

typedef volatile uint32_t reg;

typedef struct {
    reg transmit; /* if the highest bit of a read is set, the transmitter is full */
    reg receive;  /* if the highest bit of a read is set, the receiver is empty */
    reg transmit_control;
    reg receive_control;
    reg interrupts_on; /* bit 1: received bytes */
    reg interrupts;
    reg divisor;
} uart;

enum { ON = 1, RX_INTERRUPT_ON = 2 };
#define FULL 0x80000000u
#define EMPTY 0x80000000u

static uart *const UARTS[MACHINE_PORTS] = {(uart *)0x10013000, (uart *)0x10023000};
enum { UART0_INTERRUPT = 3, UART1_INTERRUPT = 4 };

/* The interrupt controller. */
#define PLIC_PRIORITY(n) (((reg *)0x0C000000)[n])
#define PLIC_ON (*(reg *)0x0C002000)
#define PLIC_CLAIM (*(reg *)0x0C200004)

/* The clock, and the time of its next interrupt. QEMU's clock runs at 10 MHz. The clock of a real FE310 runs at 32,768 Hz: 32.8 ticks a
 * millisecond. */
#define TIME_LOW (*(reg *)0x0200BFF8)
#define TIME_HIGH (*(reg *)0x0200BFFC)
#define ALARM_LOW (*(reg *)0x02004000)
#define ALARM_HIGH (*(reg *)0x02004004)
#define TICKS_PER_MS 10000

/* ---- Clock ---- */

static uint64_t alarm;

static void set_alarm(uint64_t at)
{
    alarm = at;
    ALARM_HIGH = 0xFFFFFFFF; /* no alarm while only half of the time is written */
    ALARM_LOW = (uint32_t)at;
    ALARM_HIGH = (uint32_t)(at >> 32);
}

static void tick(void)
{
    machine_tick();
    set_alarm(alarm + TICKS_PER_MS);
}

/* ---- Interrupts ---- */

static void receive(uint8_t port)
{
    uint32_t data;
    while (!((data = UARTS[port]->receive) & EMPTY))
        machine_receive(port, (uint8_t)data);
}

#define TRAP_TIMER 0x80000007u
#define TRAP_EXTERNAL 0x8000000Bu

__attribute__((interrupt("machine"), aligned(4))) static void trap(void)
{
    uint32_t cause;
    __asm__ volatile("csrr %0, mcause" : "=r"(cause));
    if (cause == TRAP_TIMER) {
        tick();
    } else if (cause == TRAP_EXTERNAL) {
        uint32_t interrupt = PLIC_CLAIM;
        if (interrupt == UART0_INTERRUPT)
            receive(MACHINE_LINE);
        else if (interrupt == UART1_INTERRUPT)
            receive(MACHINE_PANEL);
        PLIC_CLAIM = interrupt;
    } else {
        machine_halt(); /* a fault of the program */
    }
}

/* ---- Start ---- */

/* Sets the stack, and the register gp, which the compiler uses to address data. */
__asm__(".section .start, \"ax\"\n"
        ".globl start\n"
        "start:\n"
        ".option push\n"
        ".option norelax\n"
        "la gp, __global_pointer$\n"
        ".option pop\n"
        "la sp, stack_top\n"
        "j machine_reset\n"
        ".text\n");

void machine_start(void)
{
    uint8_t port;
    __asm__ volatile("csrw mtvec, %0" ::"r"(trap));
    /* QEMU forgets an interrupt that is pending when PLIC_ON enables it, so PLIC_ON comes before the ports. */
    PLIC_PRIORITY(UART0_INTERRUPT) = 1;
    PLIC_PRIORITY(UART1_INTERRUPT) = 1;
    PLIC_ON = 1u << UART0_INTERRUPT | 1u << UART1_INTERRUPT;
    for (port = 0; port < MACHINE_PORTS; port++) {
        UARTS[port]->divisor = CLOCK_HZ / MACHINE_BAUD - 1;
        UARTS[port]->transmit_control = ON;
        UARTS[port]->receive_control = ON;
        UARTS[port]->interrupts_on = RX_INTERRUPT_ON;
    }
    set_alarm((uint64_t)TIME_HIGH << 32 | TIME_LOW); /* the upper half does not change between the two reads */
    __asm__ volatile("csrs mie, %0" ::"r"(1u << 11 | 1u << 7)); /* external interrupts and the clock's interrupt */
    __asm__ volatile("csrsi mstatus, 8");                        /* enables all interrupts */
}

void machine_put(uint8_t port, uint8_t byte)
{
    while (UARTS[port]->transmit & FULL)
        ;
    UARTS[port]->transmit = byte;
}

void machine_sleep(void)
{
    __asm__ volatile("wfi");
}
