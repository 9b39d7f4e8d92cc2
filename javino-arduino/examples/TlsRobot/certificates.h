// Put your certificates into this file. The first command makes the board's certificate, the second the computer's:
//
//   openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 -subj /CN=robot -keyout robot.key -out robot.crt
//   openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 -subj /CN=me -keyout computer.key -out computer.crt
//
// Put computer.crt and computer.key into ~/.argo/tls on the computer. Put robot.crt there too, as HOST_4433.crt, where HOST is the host
// in the port's name. Anybody with robot.key can impersonate the board, so keep this file secret.

#ifndef CERTIFICATES_H
#define CERTIFICATES_H

const char BOARD_CERTIFICATE[] = R"(
the text of robot.crt
)";

const char BOARD_KEY[] = R"(
the text of robot.key
)";

const char COMPUTER_CERTIFICATE[] = R"(
the text of computer.crt
)";

#endif
