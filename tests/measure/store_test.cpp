#include "framework/measure/store.h"

#include "framework/base/files.h"
#include "framework/measure/digest.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace luch {
namespace {

namespace fs = std::filesystem;

TEST(Digest, HasThePublishedValues) {
    // FIPS 180-2, appendix B; NIST's example files.
    EXPECT_EQ(digest_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(digest_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(digest_of(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, KeepsPartsApart) {
    EXPECT_NE(Digest().part("ab").part("c").text(), Digest().part("a").part("bc").text());
}

/// A folder of its own for each test.
class StoreFolder : public ::testing::Test {
 protected:
    ~StoreFolder() override { fs::remove_all(folder_); }
    fs::path folder_ = own_folder();
};

TEST_F(StoreFolder, DigestsFilesByTheirBytesAndNotByTheirNames) {
    write_text(folder_ / "a", "one");
    write_text(folder_ / "b", "one");
    write_text(folder_ / "c", "two");
    const auto digest = [&](const char* name) {
        return digest_of_files(std::array{folder_ / name});
    };
    EXPECT_EQ(digest("a"), digest("b"));
    EXPECT_NE(digest("a"), digest("c"));
    EXPECT_NE(digest("a"), digest("absent"));
}

TEST_F(StoreFolder, GivesBackWhatWasPutAndNothingElse) {
    const Store store(folder_ / "deep" / "er");
    EXPECT_FALSE(store.get("key"));
    const std::string bytes("a\0b\n", 4);
    EXPECT_TRUE(store.put("key", bytes));
    EXPECT_EQ(store.get("key"), bytes);
    EXPECT_FALSE(store.get("other"));
    EXPECT_TRUE(store.put("key", ""));
    EXPECT_EQ(store.get("key"), "");
}

TEST_F(StoreFolder, TakesADamagedFileForNone) {
    const Store store(folder_);
    for (const std::size_t at : {std::size_t{0}, std::size_t{70}}) {
        ASSERT_TRUE(store.put("key", "some bytes"));
        std::string whole = read_text(folder_ / "key.luch");
        whole[at] ^= 1;
        write_text(folder_ / "key.luch", whole);
        EXPECT_FALSE(store.get("key")) << at;
        EXPECT_FALSE(fs::exists(folder_ / "key.luch"));
    }
    write_text(folder_ / "key.luch", "short");
    EXPECT_FALSE(store.get("key"));
}

TEST_F(StoreFolder, RemovesWhatWasUnusedForLongestWhenItHoldsTooMuch) {
    const Store store(folder_, 1000);
    const std::string bytes(300, 'x');  // 364 with the checksum
    ASSERT_TRUE(store.put("a", bytes));
    ASSERT_TRUE(store.put("b", bytes));
    const auto older = [&](const char* name, int seconds) {
        fs::last_write_time(folder_ / name,
                            fs::file_time_type::clock::now() - std::chrono::seconds(seconds));
    };
    older("a.luch", 20);
    older("b.luch", 10);
    EXPECT_TRUE(store.get("a"));  // now b is the one unused for longest
    ASSERT_TRUE(store.put("c", bytes));
    EXPECT_TRUE(store.get("a"));
    EXPECT_FALSE(store.get("b"));
    EXPECT_TRUE(store.get("c"));
}

TEST_F(StoreFolder, SaysThatItCannotWriteAndThrowsNothing) {
    write_text(folder_ / "file", "");
    const Store store(folder_ / "file" / "folder");
    EXPECT_FALSE(store.put("key", "bytes"));
    EXPECT_FALSE(store.get("key"));
}

TEST_F(StoreFolder, ClearsItsOwnFilesOnly) {
    const Store store(folder_);
    ASSERT_TRUE(store.put("key", "bytes"));
    write_text(folder_ / "mine.txt", "");
    store.clear();
    EXPECT_FALSE(store.get("key"));
    EXPECT_TRUE(fs::exists(folder_ / "mine.txt"));
}

TEST(CacheFolder, FollowsTheXdgVariablesWhereTheyAreAbsolute) {
    const auto with = [](const char* cache, const char* home) {
        setenv("XDG_CACHE_HOME", cache, 1);
        setenv("HOME", home, 1);
        return default_cache_folder();
    };
    EXPECT_EQ(with("/tmp/x", "/tmp/h"), fs::path("/tmp/x/luch"));
    EXPECT_EQ(with("", "/tmp/h"), fs::path("/tmp/h/.cache/luch"));
    EXPECT_EQ(with("relative", "/tmp/h"), fs::path("/tmp/h/.cache/luch"));
    EXPECT_EQ(with("", ""), fs::path());
}

}  // namespace
}  // namespace luch
