/**
 * @file A MIPS32 without any library. QEMU emulates it with `qemu-system-mipsel -M malta -cpu 24Kf`. The processor belongs to the family
 *     of the PIC32MZ EF and is little-endian. The ports and the interrupt controller are those of a PC.
 */
#include "start.h"

/* ---- Registers ---- */

/* The ports of the ISA bus, in the uncached segment. */
#define ISA(port) (*(volatile uint8_t *)(0xB8000000u + (port)))

#define UART(port, reg) ISA((port) == MACHINE_LINE ? 0x3F8u + (reg) : 0x2F8u + (reg))
enum { UART_DATA, UART_INTERRUPTS, UART_FIFO, UART_FRAME, UART_MODEM, UART_STATE };
enum { RX_INTERRUPT = 1, RX_READY = 1, TX_EMPTY = 0x20, EIGHT_BITS = 3, DIVISOR = 0x80, OUTPUT_2 = 8 };
#define UART_CLOCK_HZ 1843200u

enum { PIC_COMMAND = 0x20, PIC_DATA = 0x21, PIC_BEGIN = 0x11, PIC_SECOND_AT_2 = 4, PIC_AUTOMATIC_END = 3, PIC_TAKE = 0x0C };
enum { TIMER_IRQ = 0, PANEL_IRQ = 3, LINE_IRQ = 4 };

enum { TIMER_DATA = 0x40, TIMER_MODE = 0x43, TIMER_AGAIN = 0x34 };
#define TIMER_HZ 1193182u

/* Bits of the processor's registers. */
#define CONTROLLER_ON (1u << 10)
#define INTERRUPTS_ON 1u
#define FLOATING_POINT_ON (1u << 29)
#define EXCEPTION (31u << 2)

#define READ(register, select) \
    ({ \
        uint32_t value_; \
        __asm__ volatile("mfc0 %0, $" #register ", " #select : "=r"(value_)); \
        value_; \
    })
#define WRITE(register, select, value) __asm__ volatile("mtc0 %0, $" #register ", " #select "\n ehb" ::"r"((uint32_t)(value)) : "memory")

#define READ_COUNT() READ(9, 0)
#define STATUS(value) WRITE(12, 0, value)
#define CAUSE() READ(13, 0)

#define COUNTS_PER_MS 160000u

/* ---- Interrupts ---- */

static void receive(uint8_t port)
{
    while (UART(port, UART_STATE) & RX_READY)
        machine_receive(port, UART(port, UART_DATA));
}

/* Late interrupts of the timer merge into one. The processor's counter shows how many milliseconds have passed. */
static void tick(void)
{
    static uint32_t counted;
    for (; READ_COUNT() - counted >= COUNTS_PER_MS; counted += COUNTS_PER_MS)
        machine_tick();
}

/* Handles all interrupts and exceptions, which share one vector. The controller reports each byte only once. If this function misses a
 * byte, it reads the byte at the next interrupt. */
__attribute__((interrupt, keep_interrupts_masked, used)) static void interrupted(void)
{
    if (CAUSE() & EXCEPTION)
        machine_halt();
    ISA(PIC_COMMAND) = PIC_TAKE;
    (void)ISA(PIC_COMMAND);
    tick();
    receive(MACHINE_LINE);
    receive(MACHINE_PANEL);
}

/* Interrupts use these vectors after the code below has cleared the bit that selects the boot vectors. */
__asm__(".section .vectors, \"ax\"\n"
        ".set noreorder\n"
        "vectors: .space 0x180\n"
        "j interrupted\n"
        "nop\n"
        ".globl start\n"
        "start: lui $t0, 0x40\n"
        "mtc0 $t0, $12\n"
        "ehb\n"
        "la $t0, vectors\n"
        "mtc0 $t0, $15, 1\n"
        "mtc0 $zero, $12\n"
        "ehb\n"
        "la $sp, stack_top - 16\n"
        "j machine_reset\n"
        "nop\n"
        ".set reorder\n"
        ".previous\n");

/* ---- Start ---- */

static void open_port(uint8_t port)
{
    UART(port, UART_FRAME) = DIVISOR;
    UART(port, UART_DATA) = UART_CLOCK_HZ / 16 / MACHINE_BAUD;
    UART(port, UART_INTERRUPTS) = 0;
    UART(port, UART_FRAME) = EIGHT_BITS;
    UART(port, UART_MODEM) = OUTPUT_2; /* enables the interrupt line */
    UART(port, UART_INTERRUPTS) = RX_INTERRUPT;
}

void machine_start(void)
{
    ISA(PIC_COMMAND) = PIC_BEGIN;
    ISA(PIC_DATA) = 0;
    ISA(PIC_DATA) = PIC_SECOND_AT_2;
    ISA(PIC_DATA) = PIC_AUTOMATIC_END;
    ISA(PIC_DATA) = (uint8_t)~(1 << TIMER_IRQ | 1 << PANEL_IRQ | 1 << LINE_IRQ);
    open_port(MACHINE_LINE);
    open_port(MACHINE_PANEL);
    ISA(TIMER_MODE) = TIMER_AGAIN;
    ISA(TIMER_DATA) = (uint8_t)(TIMER_HZ / 1000);
    ISA(TIMER_DATA) = TIMER_HZ / 1000 >> 8;
    STATUS(FLOATING_POINT_ON | CONTROLLER_ON | INTERRUPTS_ON);
}

void machine_put(uint8_t port, uint8_t byte)
{
    while (!(UART(port, UART_STATE) & TX_EMPTY))
        ;
    UART(port, UART_DATA) = byte;
}

void machine_sleep(void)
{
    __asm__ volatile("wait" ::: "memory");
}
