// The texts of actions: literals, their arguments, whole numbers.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "javino_literal.h"

TEST_CASE("a literal is taken apart outside quotes and brackets") {
  auto functor = [](const std::string &text) { return javino_functor(text.data(), static_cast<uint8_t>(text.size())); };
  CHECK(functor("ledOn") == 5);
  CHECK(functor("speed(120)") == 5);
  CHECK(functor("say(\"hi; you)\")") == 3);
  CHECK(functor("move(left,pos(1,[2,3]))[now]") == 4);
  CHECK(functor("go()[a]") == 2);
  CHECK(functor("go[a]") == 2);
  CHECK(functor("f(\",\",',')") == 1);
  CHECK(functor("drive('C:\\')") == 5);
  CHECK(functor("f((((((((((((((((((((1))))))))))))))))))))") == 1);
  for (const char *bad : {"", "speed(120", "speed 120)", "speed(1)(2)", "speed(1)x", "speed)", "say(\"hi)", "(1)", "go[a](1)", "a\"b\"", "speed(1]]", "speed(1]", "speed(1}", "f([1)]", "f(,1)", "f(1,)", "f(1,,2)", "f( , 1)", "f([,1])"}) {
    INFO(bad);
    CHECK(functor(bad) == 0);
  }
  std::string text = "move( left , \"a,b(\" ,pos(1,2),-7)[x(9)]";
  const char *argument;
  std::vector<std::string> found;
  for (uint8_t i = 0;; i++) {
    uint8_t n = javino_argument(text.data(), static_cast<uint8_t>(text.size()), i, &argument);
    if (!n)
      break;
    found.push_back(std::string(argument, n));
  }
  CHECK(found == std::vector<std::string>{"left", "\"a,b(\"", "pos(1,2)", "-7"});
}

TEST_CASE("whole numbers are read, others are not") {
  auto number = [](const std::string &text) {
    int32_t value = 4711;
    bool read = javino_number(text.data(), static_cast<uint8_t>(text.size()), &value);
    return read ? std::to_string(value) : "none";
  };
  CHECK(number("120") == "120");
  CHECK(number("-7") == "-7");
  CHECK(number("+7") == "7");
  CHECK(number("2147483647") == "2147483647");
  CHECK(number("-2147483648") == "-2147483648");
  for (const char *bad : {"", "-", "+", "1.5", "x", "12x", "2147483648", "-2147483649", "99999999999999", " 1"})
    CHECK(number(bad) == "none");
}
