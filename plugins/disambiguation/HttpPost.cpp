// SPDX-License-Identifier: BSD-3-Clause
#include "HttpPost.h"

#include "ServerUrl.h"
#include "voxeland/base/RefusedMemory.h"
#include "voxeland/base/numbers.h"
#include "voxeland/base/trimmed.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <curl/curl.h>
#include <memory>
#include <strings.h>
#include <utility>

namespace voxeland
{
namespace
{
// Answers are a few kB: more is a mistake [bytes].
constexpr size_t LONGEST_BODY = 16U << 20U, LONGEST_HEADERS = 64U << 10U;
constexpr auto BODY_TOO_LARGE = "its reply is larger than 16 MiB";
constexpr auto HEADERS_TOO_LARGE = "the headers of its reply are larger than 64 KiB";

/** What has come so far. */
struct Receiving
{
    HttpReply reply;
    size_t headerBytes = 0;
    const char* tooLarge = nullptr;  //!< why no more is received
};

struct ListDeleter
{
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using HeaderList = std::unique_ptr<curl_slist, ListDeleter>;

void append(HeaderList& list, const std::string& line)
{
    curl_slist* longer = curl_slist_append(list.get(), line.c_str());
    if (longer == nullptr) throw std::bad_alloc();
    list.release();
    list.reset(longer);
}

size_t receiveBody(const char* data, size_t, size_t bytes, void* receiving)
{
    auto& to = *static_cast<Receiving*>(receiving);
    if (to.reply.body.size() + bytes > LONGEST_BODY) {
        to.tooLarge = BODY_TOO_LARGE;
        return 0;
    }
    to.reply.body.append(data, bytes);
    return bytes;
}

size_t receiveHeader(const char* data, size_t, size_t bytes, void* receiving)
{
    auto& to = *static_cast<Receiving*>(receiving);
    to.headerBytes += bytes;
    if (to.headerBytes > LONGEST_HEADERS) {
        to.tooLarge = HEADERS_TOO_LARGE;
        return 0;
    }
    const std::string line(data, bytes);
    const size_t colon = line.find(':');
    if (colon == std::string::npos) return bytes;
    const std::string name = line.substr(0, colon), value = trimmed(line.substr(colon + 1));
    if (strcasecmp(name.c_str(), "retry-after") == 0) to.reply.retryAfter = secondsToWait(value);
    if (strcasecmp(name.c_str(), "location") == 0) to.reply.location = value;
    return bytes;
}

/** Whether libcurl took a line of the headers for too long, which it calls a lack of memory. */
bool isHeaderTooLong(CURLcode code)
{
#if LIBCURL_VERSION_NUM >= 0x080600
    if (code == CURLE_TOO_LARGE) return true;
#endif
    return code == CURLE_OUT_OF_MEMORY && errno != ENOMEM;
}

/** \param connected whether there was a connection before it failed */
HttpError::Kind kindOf(CURLcode code, bool connected)
{
    switch (code) {
        case CURLE_PEER_FAILED_VERIFICATION:
        case CURLE_SSL_CACERT_BADFILE:
        case CURLE_SSL_CONNECT_ERROR:
            return HttpError::Kind::Untrusted;
        case CURLE_OPERATION_TIMEDOUT:
            return connected ? HttpError::Kind::TimedOut : HttpError::Kind::NotConnected;
        default:
            return connected ? HttpError::Kind::BrokenOff : HttpError::Kind::NotConnected;
    }
}
}  // namespace

HttpReply post(const HttpRequest& request)
{
    static const CURLcode library = curl_global_init(CURL_GLOBAL_DEFAULT);
    const std::unique_ptr<CURL, void (*)(CURL*)> handle(curl_easy_init(), curl_easy_cleanup);
    CURL* const curl = handle.get();
    if (library != CURLE_OK || curl == nullptr) throw std::runtime_error("libcurl does not start");

    HeaderList headers;
    append(headers, "Content-Type: application/json");
    append(headers, "Accept: application/json");
    append(headers, "Expect:");  // servers that do not answer "100 Continue" would cost a second
    if (!request.key.empty()) append(headers, "Authorization: Bearer " + request.key);

    Receiving receiving;
    char reason[CURL_ERROR_SIZE] = "";
    const auto milliseconds = [](double s) { return std::max(1L, static_cast<long>(s * 1000)); };
    curl_easy_setopt(curl, CURLOPT_URL, request.url.c_str());
    curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
    curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 0L);  // pictures and key go nowhere else
    const bool isReadable = !request.key.empty() && isUnencrypted(request.url);
    if (isThisMachine(request.url) || isReadable)  // whatever http_proxy says: no proxy sees it
        curl_easy_setopt(curl, CURLOPT_NOPROXY, "*");
    curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);  // several threads
    curl_easy_setopt(curl, CURLOPT_USERAGENT, "voxeland");
    curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
    curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE,
                     static_cast<curl_off_t>(request.body.size()));
    curl_easy_setopt(curl, CURLOPT_POSTFIELDS, request.body.data());
    curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT_MS, milliseconds(request.connectTimeout));
    curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, milliseconds(request.timeout));
    curl_easy_setopt(curl, CURLOPT_SSL_VERIFYPEER, 1L);
    curl_easy_setopt(curl, CURLOPT_SSL_VERIFYHOST, 2L);
    if (!request.caFile.empty()) curl_easy_setopt(curl, CURLOPT_CAINFO, request.caFile.c_str());
    curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, receiveBody);
    curl_easy_setopt(curl, CURLOPT_WRITEDATA, &receiving);
    curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, receiveHeader);
    curl_easy_setopt(curl, CURLOPT_HEADERDATA, &receiving);
    curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, reason);

    errno = 0;
    const CURLcode code = curl_easy_perform(curl);
    if (isHeaderTooLong(code)) receiving.tooLarge = HEADERS_TOO_LARGE;
    if (code != CURLE_OK) RefusedMemory::noteErrno();
    if (receiving.tooLarge != nullptr)
        throw HttpError(HttpError::Kind::TooLarge, receiving.tooLarge);
    if (code != CURLE_OK) {
        curl_off_t connected = 0;
        curl_easy_getinfo(curl, CURLINFO_CONNECT_TIME_T, &connected);
        throw HttpError(kindOf(code, connected > 0),
                        reason[0] != '\0' ? reason : curl_easy_strerror(code));
    }
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &receiving.reply.status);
    return std::move(receiving.reply);
}

std::optional<double> secondsToWait(const std::string& retryAfter)
{
    if (retryAfter.empty()) return std::nullopt;
    if (const auto seconds = parsed<double>(retryAfter); seconds && *seconds >= 0) return seconds;
    const time_t then = curl_getdate(retryAfter.c_str(), nullptr);
    if (then == -1) return std::nullopt;
    return std::max(0.0, std::difftime(then, std::time(nullptr)));
}
}  // namespace voxeland
