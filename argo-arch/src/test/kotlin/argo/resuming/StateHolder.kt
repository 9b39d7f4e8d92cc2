package argo.resuming

import java.nio.file.Path

/** A program that reserves the file `robot.state` in the folder [arguments] until it is killed. */
internal fun main(arguments: Array<String>) {
    StateFile.take(Path.of(arguments.single(), "robot.state")).use { file ->
        println(if (file == null) "refused" else "taken")
        readln()
    }
}
