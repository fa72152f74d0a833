#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// .ci/deps among counterfeit programs: a dpkg-query that knows one package, an apt-get that only takes notes.
namespace {
namespace fs = std::filesystem;

class Deps : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(programs_);
    for (const char* name : {"bash", "sh", "sed", "comm", "sort", "mktemp", "rm", "tail", "env"})
      fs::create_symlink(fs::path("/usr/bin") / name, programs_ / name);
    counterfeit("dpkg-query", "echo 'installed present'");
    counterfeit(
        "apt-get",
        "echo \"$DEBIAN_FRONTEND $*\" >>\"$NOTES\"; case \"$*\" in *broken*) echo no such package; exit 100;; esac");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void counterfeit(const std::string& name, const std::string& body) {
    std::ofstream(programs_ / name) << "#!/bin/sh\n" << body << '\n';
    fs::permissions(programs_ / name, fs::perms::owner_all);
  }

  /// Exit code of .ci/deps for these packages; what it says and what apt-get was asked stand in said() and asked().
  int deps(const std::string& packages) {
    const std::string command = "DEBIAN_FRONTEND= NOTES='" + (folder_ / "asked").string() + "' PATH='" +
                                programs_.string() + "' /usr/bin/bash '" + TALUS_SOURCE_DIR "/.ci/deps' " + packages +
                                " >'" + (folder_ / "said").string() + "' 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] std::string said() const { return text("said"); }
  [[nodiscard]] std::string asked() const { return text("asked"); }

 private:
  [[nodiscard]] std::string text(const char* name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("talus_deps_" + std::to_string(getpid()));

 protected:
  const fs::path programs_ = folder_ / "bin";
};

TEST_F(Deps, AsksNobodyWhereNothingIsMissing) {
  counterfeit("id", "echo 1000");
  EXPECT_EQ(deps("present"), 0);
  EXPECT_EQ(asked(), "");
  EXPECT_EQ(said(), "");
}

TEST_F(Deps, InstallsWhatIsMissingAsRoot) {
  counterfeit("id", "echo 0");
  EXPECT_EQ(deps("present missing"), 0) << said();
  EXPECT_NE(asked().find(" update\n"), std::string::npos) << asked();
  EXPECT_NE(asked().find("noninteractive -qq"), std::string::npos) << asked();
  EXPECT_NE(asked().find("install --yes --no-install-recommends missing\n"), std::string::npos) << asked();
}

TEST_F(Deps, InstallsThroughSudoAsAUser) {
  counterfeit("id", "echo 1000");
  counterfeit("sudo", "SUDO=sudoed exec \"$@\"");
  counterfeit("apt-get", "echo \"$SUDO $*\" >>\"$NOTES\"");
  EXPECT_EQ(deps("missing"), 0) << said();
  EXPECT_NE(asked().find("sudoed "), std::string::npos) << asked();
}

TEST_F(Deps, SaysWhatToTypeWithoutRootAndSudo) {
  counterfeit("id", "echo 1000");
  EXPECT_EQ(deps("present missing"), 1);
  EXPECT_EQ(asked(), "");
  EXPECT_NE(said().find("apt-get install --no-install-recommends missing"), std::string::npos) << said();
}

TEST_F(Deps, ShowsTheLastWordsOfAFailedInstallation) {
  counterfeit("id", "echo 0");
  EXPECT_EQ(deps("broken"), 1);
  EXPECT_NE(said().find("no such package"), std::string::npos) << said();
}

TEST_F(Deps, TrustsAMachineWithoutDpkg) {
  fs::remove(programs_ / "dpkg-query");
  EXPECT_EQ(deps("missing"), 0);
  EXPECT_EQ(asked(), "");
}
}  // namespace
