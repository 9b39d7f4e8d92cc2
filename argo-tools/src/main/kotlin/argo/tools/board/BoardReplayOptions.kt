package argo.tools.board

import picocli.CommandLine.Option
import java.nio.file.Path

internal class BoardReplayOptions {
    @Option(names = ["--loop"], description = ["restarts at the end of the recording"])
    var loop = false
        private set

    @Option(names = ["--in-turn"], description = ["answers the first request with the first answer and so on, ignoring times"])
    var inTurn = false
        private set

    @Option(names = ["--link"], paramLabel = "PATH", description = ["a symbolic link to the pseudo-terminal, such as /tmp/ttyBOARD"])
    var link: Path? = null
        private set
}
