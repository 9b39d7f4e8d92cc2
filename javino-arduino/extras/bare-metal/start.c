#include "start.h"

/* ---- Received bytes and the clock ---- */

/*
 * The size of a port's ring, a power of two, at most 256, and greater than JAVINO_CREDIT. A ring holds at most RING_BYTES - 1 received
 * bytes.
 */
#define RING_BYTES 256

/*
 * Only the receive interrupt adds bytes, and only the main loop takes them. On a machine with one core, neither needs to lock the other
 * out.
 */
static struct {
    volatile uint8_t bytes[RING_BYTES];
    volatile uint16_t put;
    volatile uint16_t taken;
} received[MACHINE_PORTS];

static volatile uint32_t ms;

void machine_receive(uint8_t port, uint8_t byte)
{
    uint16_t next = (uint16_t)(received[port].put + 1) % RING_BYTES;
    if (next == received[port].taken)
        return;
    received[port].bytes[received[port].put] = byte;
    received[port].put = next;
}

int machine_take(uint8_t port)
{
    uint16_t at = received[port].taken;
    uint8_t byte;
    if (at == received[port].put)
        return -1;
    byte = received[port].bytes[at];
    received[port].taken = (uint16_t)(at + 1) % RING_BYTES;
    return byte;
}

void machine_tick(void)
{
    ms++;
}

uint32_t machine_ms(void)
{
    return ms;
}

/* ---- Start ---- */

/* Addresses that the linker script defines. */
extern uint32_t data_begin[], data_end[], data_source[], bss_begin[], bss_end[];
typedef void (*function)(void);
extern const function constructors_begin[], constructors_end[];
int main(void);

void machine_halt(void)
{
    for (;;)
        ;
}

void machine_reset(void)
{
    const uint32_t *from = data_source;
    uint32_t *to;
    const function *constructor;
    for (to = data_begin; to < data_end;)
        *to++ = *from++;
    for (to = bss_begin; to < bss_end;)
        *to++ = 0;
    for (constructor = constructors_begin; constructor < constructors_end; constructor++)
        (*constructor)();
    main();
    machine_halt();
}
