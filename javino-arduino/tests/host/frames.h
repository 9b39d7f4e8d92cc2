/** @file Frames as a far end writes them, made from the protocol's definition and not with the library. */
#ifndef FRAMES_H
#define FRAMES_H

#include <cstdint>
#include <cstdio>
#include <string>

inline unsigned crcOf(const std::string &bytes) {
  unsigned crc = 0xFFFF;
  for (unsigned char byte : bytes) {
    crc ^= static_cast<unsigned>(byte) << 8;
    for (int i = 0; i < 8; i++)
      crc = ((crc << 1) ^ (crc & 0x8000 ? 0x1021 : 0)) & 0xFFFF;
  }
  return crc;
}

inline std::string hexOf(unsigned value, int digits) {
  char text[9];
  snprintf(text, sizeof text, "%0*X", digits, value);
  return text;
}

inline std::string frame1(const std::string &payload) {
  return "fffe" + hexOf(static_cast<unsigned>(payload.size()), 2) + payload;
}

inline std::string frame2(const std::string &payload, unsigned flags, unsigned sequence) {
  std::string body = hexOf(static_cast<unsigned>(payload.size()), 2) + hexOf(flags, 1) + hexOf(sequence, 1) + payload;
  return "fffd" + body + hexOf(crcOf(body), 4);
}

#endif
