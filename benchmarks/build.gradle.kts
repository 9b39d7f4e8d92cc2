plugins { application }

application {
    mainClass = "benchmarks.MainKt"
    applicationDefaultJvmArgs = listOf("--enable-native-access=ALL-UNNAMED") // jSerialComm loads a native library
}
