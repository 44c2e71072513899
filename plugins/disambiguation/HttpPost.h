// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <stdexcept>
#include <string>

namespace voxeland
{
/** A request with a JSON body. */
struct HttpRequest
{
    std::string url, body;
    std::string key;     //!< sent as `Authorization: Bearer`; empty: none
    std::string caFile;  //!< certificates (PEM) to trust instead of the system's; empty: those
    double connectTimeout = 0;  //!< longest time until connected [s]
    double timeout = 0;         //!< longest time for everything [s]
};

/** What a server answered, whatever its status. */
struct HttpReply
{
    long status = 0;  //!< 200, 404, ...
    std::string body;
    std::string location;              //!< where a redirect leads; redirects are not followed
    std::optional<double> retryAfter;  //!< when the server wants to be asked again [s from now]
};

/** There is no complete answer. The sentence does not hold the key. */
struct HttpError : std::runtime_error
{
    enum class Kind
    {
        NotConnected,  //!< no such host, nobody listens, ...
        BrokenOff,     //!< the connection ended within the answer or before
        TimedOut,      //!< connected, but no complete answer in time
        Untrusted,     //!< the certificate is not what it should be
        TooLarge       //!< what came is beyond any answer
    };
    HttpError(Kind what, const std::string& sentence) : std::runtime_error(sentence), kind(what) {}
    Kind kind;
};

/** POSTs a request and waits for the answer. A proxy of the environment (https_proxy ...) is used,
 * but not for this machine, nor for a key that it could read. May be called from several threads.
 *  \throws HttpError if there is none */
HttpReply post(const HttpRequest& request);

/** Meaning of a Retry-After header: a number of seconds, or a date. None if it is neither. */
std::optional<double> secondsToWait(const std::string& retryAfter);
}  // namespace voxeland
