// Errors as tests expect them.
#pragma once

#include "vesper/base/error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vesper::test {

/// That the call throws an Error of the kind whose text holds all words, with a remedy.
template <class Call> void expect_error(ErrorKind kind, const std::vector<std::string>& words, const Call& call) {
  try {
    static_cast<void>(call());
    ADD_FAILURE() << "no error; should say " << words.front();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_FALSE(error.context().remedy.empty()) << error.what();
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what() << "\nshould say " << word;
    }
  }
}

} // namespace vesper::test
