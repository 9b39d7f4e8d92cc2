plugins { application }

dependencies {
    implementation(project(":argo-arch"))
    implementation(libs.jason)
    implementation(libs.jmh.core)
    annotationProcessor(libs.jmh.processor)
}

application { mainClass = "benchmarks.MainKt" }
