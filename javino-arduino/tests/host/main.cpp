#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <Arduino.h>

#include "frames.h"

FakeSerial Serial;
FakeSerial Serial1;
unsigned long stub_millis;
int stub_pins[40];

namespace {

/** Each case begins with the session of hello(). */
struct FirstSession : doctest::IReporter {
  explicit FirstSession(const doctest::ContextOptions &) {}
  void test_case_start(const doctest::TestCaseData &) override { session = 7; }
  void report_query(const doctest::QueryData &) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats &) override {}
  void test_case_reenter(const doctest::TestCaseData &) override {}
  void test_case_end(const doctest::CurrentTestCaseStats &) override {}
  void test_case_exception(const doctest::TestCaseException &) override {}
  void subcase_start(const doctest::SubcaseSignature &) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData &) override {}
  void log_message(const doctest::MessageData &) override {}
  void test_case_skipped(const doctest::TestCaseData &) override {}
};
REGISTER_LISTENER("first session", 1, FirstSession);

}  // namespace
