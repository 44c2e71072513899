// SPDX-License-Identifier: BSD-3-Clause
#include "ServerUrl.h"

#include <arpa/inet.h>
#include <curl/curl.h>
#include <memory>
#include <strings.h>

namespace voxeland
{
namespace
{
/** A part of a URL; empty if it is no URL. */
std::string partOf(const std::string& url, CURLUPart part)
{
    const std::unique_ptr<CURLU, void (*)(CURLU*)> parsed(curl_url(), curl_url_cleanup);
    char* text = nullptr;
    if (!parsed || curl_url_set(parsed.get(), CURLUPART_URL, url.c_str(), 0) != CURLUE_OK ||
        curl_url_get(parsed.get(), part, &text, 0) != CURLUE_OK)
        return {};
    std::string result = text;
    curl_free(text);
    return result;
}
}  // namespace

bool isThisMachine(const std::string& url)
{
    std::string host = partOf(url, CURLUPART_HOST);
    if (strcasecmp(host.c_str(), "localhost") == 0) return true;
    in_addr v4{};
    if (inet_pton(AF_INET, host.c_str(), &v4) == 1)
        return (ntohl(v4.s_addr) >> 24U) == IN_LOOPBACKNET;
    if (host.size() > 2 && host.front() == '[') host = host.substr(1, host.size() - 2);
    in6_addr v6{};
    return inet_pton(AF_INET6, host.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

bool isUnencrypted(const std::string& url)
{
    return partOf(url, CURLUPART_SCHEME) != "https";
}
}  // namespace voxeland
