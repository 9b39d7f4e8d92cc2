plugins { application }

dependencies {
    implementation(project(":argo-arch"))
    implementation(libs.jason)
}

application { mainClass = "benchmarks.MainKt" }
