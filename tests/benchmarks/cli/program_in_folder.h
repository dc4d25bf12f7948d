#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {

// Runs the program in a folder of its own, without the data of whoever runs the tests.
class ProgramInFolder : public ::testing::Test {
 protected:
  std::string text_of(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // What it says; both streams.
  std::string voronaut(const std::string& arguments, int exit_code = 0) const {
    const std::string command = "cd '" + folder_.path().string() + "' && env -u VORONAUT_DATA '" +
                                VORONAUT_PROGRAM + "' " + arguments + " >said.txt" +
                                (arguments.find("2>") == std::string::npos ? " 2>&1" : "");
    const int status = std::system(command.c_str());
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, exit_code) << arguments << "\n"
                                                                       << text_of("said.txt");
    return text_of("said.txt");
  }
  std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace voronaut
