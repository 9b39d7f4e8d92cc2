package javino.sim;

import java.io.IOException;

/** A file is not a {@link Recording}; the message says where and why. */
public final class MalformedRecordingException extends IOException {
    private static final long serialVersionUID = 1L;

    MalformedRecordingException(String source, int line, String problem) {
        super(source + ":" + line + ": " + problem);
    }
}
