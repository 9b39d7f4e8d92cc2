// Put your certificates here. The first command makes the board's, the second the computer's:
//
//   openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 -subj /CN=robot -keyout robot.key -out robot.crt
//   openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 -subj /CN=me -keyout computer.key -out computer.crt
//
// The computer keeps computer.crt and computer.key in ~/.argo/tls. It keeps robot.crt there as HOST_4433.crt, with the HOST of the port's
// name. Anybody with robot.key can pass for the board: keep this file to yourself.

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
