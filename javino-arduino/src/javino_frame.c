#include "javino_frame.h"

#ifdef JAVINO_VERSION_2_ONLY
#define WRITES_2(encoder) true
#else
#define WRITES_2(encoder) ((encoder)->version2)

const char javino_preamble[4] = {'f', 'f', 'f', 'e'};
#endif

JAVINO_OUTLINE uint16_t javino_crc16(uint16_t crc, uint8_t byte)
{
    /* Divides a whole byte by the polynomial in one step. */
    uint8_t high = (uint8_t)(crc >> 8) ^ byte;
    high ^= high >> 4;
    return (uint16_t)(((uint8_t)crc ^ (uint8_t)(high << 4) ^ high >> 3) << 8) | (uint8_t)(high ^ (uint8_t)(high << 5));
}

static JAVINO_NOINLINE void put_plain(javino_encoder *e, uint8_t byte)
{
    e->write(e->context, byte);
}

#ifndef JAVINO_VERSION_2_ONLY
static JAVINO_NOINLINE void put_digit(javino_encoder *e, uint8_t digit)
{
    put_plain(e, (uint8_t)(digit + (digit < 10 ? '0' : 'A' - 10)));
}

void javino_encoder_begin(javino_encoder *encoder, uint8_t length)
{
    encoder->version2 = false;
    javino_encoder_finish(encoder, javino_preamble, sizeof javino_preamble);
    put_digit(encoder, length >> 4);
    put_digit(encoder, length & 0x0F);
}
#endif

#ifdef JAVINO_VERSION_1_ONLY

void javino_encoder_put(javino_encoder *encoder, uint8_t byte)
{
    put_plain(encoder, byte);
}

#else

void javino_encoder_begin2(javino_encoder *encoder, uint8_t nonce, uint8_t kind, uint8_t number, uint8_t length)
{
    encoder->version2 = true;
    encoder->crc = JAVINO_CRC_START(nonce);
    put_plain(encoder, JAVINO_START);
    javino_encoder_put(encoder, length);
    javino_encoder_put(encoder, kind);
    javino_encoder_put(encoder, number);
}

void javino_encoder_put(javino_encoder *encoder, uint8_t byte)
{
    encoder->crc = javino_crc16(encoder->crc, byte);
    if (WRITES_2(encoder) && (byte == JAVINO_START || byte == JAVINO_ESCAPE)) {
        put_plain(encoder, JAVINO_ESCAPE);
        byte ^= JAVINO_ESCAPED;
    }
    put_plain(encoder, byte);
}

#endif

JAVINO_NOINLINE void javino_encoder_finish(javino_encoder *encoder, const char *text, uint8_t length)
{
    while (length--)
        javino_encoder_put(encoder, (uint8_t)*text++);
#ifndef JAVINO_VERSION_1_ONLY
    if (WRITES_2(encoder)) {
        uint16_t crc = encoder->crc;
        javino_encoder_put(encoder, (uint8_t)(crc >> 8));
        javino_encoder_put(encoder, (uint8_t)crc);
    }
#endif
}

void javino_encoder_end(javino_encoder *encoder)
{
    javino_encoder_finish(encoder, NULL, 0);
}
